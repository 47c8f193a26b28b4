import type { Clock } from '../../scene/clocks/clock.ts';
import { isAlive } from '../../scene/motion/lifetimes.ts';
import { drawnFrom } from '../../scene/view/drawnFrom.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { picturedDepth, picturedEvent, projectOffset } from '../inspect/projectLine.ts';
import type { PicturePosition } from '../viewport/legend/legendState.ts';

/** A clock in a picture. */
export interface PicturedClock {
  /** Where the picture shows it, 0 … 1 both ways. */
  readonly place: PicturePosition;
  /** World time of the event that is shown [s]: when its light left, or in a slice when it is there. */
  readonly time: number;
  /** How far from the camera it is shown [m]. */
  readonly distance: number;
}

/**
 * Where a picture shows a clock, and as of when: of what hands it on, the last that exists where the picture cuts its world line.
 * Undefined where there is none, behind the camera, and out of the frame.
 */
export function picturedClock(
  { carriers }: Clock,
  observer: ViewPoint,
  settings: RenderSettings,
  size: PictureSize,
): PicturedClock | undefined {
  const viewPoint = drawnFrom(observer, settings);
  const [last] = carriers
    .flatMap(({ line, lifetime }) => {
      const event = picturedEvent(line, viewPoint, settings);
      const time = viewPoint.t + (event ? event.ahead / settings.speedOfLight : 0);
      return event && isAlive(lifetime, time) ? [{ time, offset: event.offset }] : [];
    })
    .sort((a, b) => b.time - a.time);
  const place = last && projectOffset(last.offset, viewPoint, settings, size);
  if (!place?.every((share) => share >= 0 && share <= 1)) return undefined;
  return { place, time: last!.time, distance: picturedDepth(last!.offset, viewPoint, settings) };
}
