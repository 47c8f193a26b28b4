/** Between two drawings while the picture moves, where a GPU draws [ms]. */
const MOVING_INTERVAL = 1000;

/** How it stands with the picture that is shown. */
interface PictureStatus {
  /** Another object for every picture. */
  readonly view: object;
  readonly isStill: boolean;
  readonly software: boolean;
}

/**
 * Decides when the pictures of nodes are drawn: once everything rests. While the picture moves, now and then; where the processor draws, only of what
 * there is none yet, once an edit is over.
 */
export class PictureThrottle {
  private canvas = '';
  private view: object | undefined;
  private seen: ReadonlyMap<string, object> = new Map();
  private last = Number.NEGATIVE_INFINITY;
  /** What was drawn last of each, and beside which picture. */
  private readonly drawn = new Map<string, { readonly of: object; readonly beside: object }>();

  /** `seen`: what the nodes in sight made, by name; `canvas`: how the canvas is looked at; `now` [ms]. Whoever is allowed to draws. */
  shouldRender(
    seen: ReadonlyMap<string, object>,
    canvas: string,
    { view, isStill, software }: PictureStatus,
    now: number,
  ): boolean {
    const steady = canvas === this.canvas && isSameMap(seen, this.seen);
    const still = isStill && view === this.view;
    this.canvas = canvas;
    this.seen = seen;
    this.view = view;
    if (!steady || seen.size === 0) return false;
    const lacks = (old: boolean): boolean =>
      [...seen].some(([name, of]) => {
        const drawn = this.drawn.get(name);
        return drawn?.of !== of || (old && drawn.beside !== view);
      });
    if (!lacks(still || (!software && now - this.last >= MOVING_INTERVAL))) return false;
    for (const [name, of] of seen) this.drawn.set(name, { of, beside: view });
    this.last = now;
    return true;
  }
}

const isSameMap = (a: ReadonlyMap<string, object>, b: ReadonlyMap<string, object>): boolean =>
  a.size === b.size && [...a].every(([name, of]) => b.get(name) === of);
