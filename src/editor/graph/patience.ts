/** Between two drawings while the picture moves, where a GPU draws [ms]. */
const MOVING = 1000;

/** How it stands with the picture that is shown. */
interface Standing {
  /** Another object for every picture. */
  readonly shown: object;
  readonly rests: boolean;
  readonly software: boolean;
}

/**
 * Decides when the pictures of nodes are drawn: once everything rests. While the picture moves, now and then; where the processor draws, only of what
 * there is none yet, once an edit is over.
 */
export class Patience {
  #view = '';
  #shown: object | undefined;
  #seen: ReadonlyMap<string, object> = new Map();
  #last = Number.NEGATIVE_INFINITY;
  /** What was drawn last of each, and beside which picture. */
  readonly #drawn = new Map<string, { readonly of: object; readonly beside: object }>();

  /** `seen`: what the nodes in sight made, by name; `view`: how the canvas is looked at; `now` [ms]. Whoever is allowed to draws. */
  allows(seen: ReadonlyMap<string, object>, view: string, { shown, rests, software }: Standing, now: number): boolean {
    const steady = view === this.#view && isSame(seen, this.#seen);
    const still = rests && shown === this.#shown;
    this.#view = view;
    this.#seen = seen;
    this.#shown = shown;
    if (!steady || seen.size === 0) return false;
    const lacks = (old: boolean): boolean =>
      [...seen].some(([name, of]) => {
        const drawn = this.#drawn.get(name);
        return drawn?.of !== of || (old && drawn.beside !== shown);
      });
    if (!lacks(still || (!software && now - this.#last >= MOVING))) return false;
    for (const [name, of] of seen) this.#drawn.set(name, { of, beside: shown });
    this.#last = now;
    return true;
  }
}

const isSame = (a: ReadonlyMap<string, object>, b: ReadonlyMap<string, object>): boolean =>
  a.size === b.size && [...a].every(([name, of]) => b.get(name) === of);
