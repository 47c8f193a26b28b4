import type { PickedSurface, PickResult } from '../../render/settings.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { PicturedClock } from './picturedClock.ts';

/** Least time between two readings [ms]: each waits for the GPU, and may draw a picture at rest once more. */
const INTERVAL = 250;

/** A picture, and what it shows at a pixel. */
interface ProbedPicture<View extends object> extends PictureSize {
  /** Another one for every picture that is drawn. */
  readonly view: View;
  readonly pick: (x: number, y: number) => Promise<PickResult | undefined>;
}

interface ProbedClock extends PicturedClock {
  /** Of its thing. */
  readonly path: string;
}

/** Finds out which clocks are behind other things in the picture: one at a time, each at most once for a picture. */
export class OcclusionProbe<View extends object> {
  private readonly hidden = new Map<string, boolean>();
  /** When each clock was looked for, and in which picture. */
  private readonly looked = new Map<string, { readonly view: View; readonly at: number }>();
  private busy = false;
  private since = Number.NEGATIVE_INFINITY;

  /** As of the last look. */
  isHidden(path: string): boolean {
    return this.hidden.get(path) === true;
  }

  /** Looks for the clock that it has not looked for the longest, if there is one that it has not found in this picture. `now` [ms]. Returns the running look, if any. */
  update(picture: ProbedPicture<View>, clocks: readonly ProbedClock[], now: number): Promise<void> | undefined {
    if (this.busy || now - this.since < INTERVAL) return undefined;
    const at = ({ path }: ProbedClock): number => this.looked.get(path)?.at ?? Number.NEGATIVE_INFINITY;
    const [next] = clocks
      .filter(({ path }) => this.looked.get(path)?.view !== picture.view)
      .sort((a, b) => (at(a) < at(b) ? -1 : at(a) > at(b) ? 1 : 0));
    if (!next) return undefined;
    this.since = now;
    this.looked.set(next.path, { view: picture.view, at: now });
    return this.look(picture, next);
  }

  private async look({ width, height, pick }: ProbedPicture<View>, clock: ProbedClock): Promise<void> {
    this.busy = true;
    try {
      const [x, y] = clock.place;
      const found = await pick(
        Math.min(width - 1, Math.floor(x * width)),
        Math.min(height - 1, Math.floor(y * height)),
      );
      this.hidden.set(clock.path, found?.surface !== undefined && isBefore(found.surface, clock));
    } finally {
      this.busy = false;
    }
  }
}

/** Whether a surface is nearer than a clock, and not of its thing. */
const isBefore = (surface: Pick<PickedSurface, 'path' | 'depth'>, { path, distance }: ProbedClock): boolean =>
  surface.depth < distance && surface.path !== path && !surface.path.startsWith(`${path}/`);
