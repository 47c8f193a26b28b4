/** Interval between renders while the picture moves, with a hardware GPU [ms]. */
const MOVING_INTERVAL = 1000;

/** State of the viewport's picture. */
interface PictureStatus {
  /** Identity changes with every picture. */
  readonly view: object;
  readonly isStill: boolean;
  readonly software: boolean;
}

/**
 * Decides when node pictures are rendered: when the view is at rest. While it moves, at intervals; on a software
 * renderer, only pictures that do not exist yet, after an edit is finished.
 */
export class PictureThrottle {
  private canvas = '';
  private view: object | undefined;
  private seen: ReadonlyMap<string, object> = new Map();
  private last = Number.NEGATIVE_INFINITY;
  /** For each node: the value rendered last, and the viewport's picture at that time. */
  private readonly drawn = new Map<string, { readonly of: object; readonly viewportPicture: object }>();

  /**
   * `seen`: results of the visible nodes by id; `canvas`: the canvas transform; `now` [ms]. The caller renders if it
   * returns true.
   */
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
        return drawn?.of !== of || (old && drawn.viewportPicture !== view);
      });
    if (!lacks(still || (!software && now - this.last >= MOVING_INTERVAL))) return false;
    for (const [name, of] of seen) this.drawn.set(name, { of, viewportPicture: view });
    this.last = now;
    return true;
  }
}

const isSameMap = (a: ReadonlyMap<string, object>, b: ReadonlyMap<string, object>): boolean =>
  a.size === b.size && [...a].every(([name, of]) => b.get(name) === of);
