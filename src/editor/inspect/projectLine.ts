import { conjugate, rotate } from '../../math/quat.ts';
import { length, normalize, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { hypersurfaceOf } from '../../physics/worldLines/hypersurface.ts';
import type { SimultaneousEvent } from '../../physics/worldLines/slice.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { drawnFrom } from '../../scene/view/drawnFrom.ts';
import { lensPixel } from '../../scene/view/lenses/lenses.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { hypersurfaceChoice, placementIn } from '../../scene/views/views.ts';
import type { PicturePosition } from '../viewport/legend/legendState.ts';

/** The event of a world line that a picture shows, wherever the camera looks; undefined if there is none: it is behind a horizon. */
export const picturedEvent = (
  line: WorldLine,
  { t, position, u }: Pick<ViewPoint, 't' | 'position' | 'u'>,
  settings: RenderSettings,
): SimultaneousEvent | undefined =>
  hypersurfaceOf(hypersurfaceChoice(settings)).intersect(line, { t, position }, u, settings.speedOfLight);

/** Where a picture shows an event that is observer → event `offset`, world frame [m]; undefined behind the camera. */
export function projectOffset(
  offset: Vec3,
  viewPoint: Omit<ViewPoint, 't' | 'position'>,
  settings: RenderSettings,
  { width, height }: PictureSize,
): PicturePosition | undefined {
  const { orientation, lens } = viewPoint;
  const place = normalize(rotate(conjugate(orientation), fromCamera(offset, viewPoint, settings)));
  const pixel = lensPixel(lens, place, { width, height });
  return pixel && [pixel[0] / width, pixel[1] / height];
}

/** How far from the camera a picture shows an event that is observer → event `offset`, world frame: its depth [m]. */
export const picturedDepth = (...shown: Parameters<typeof fromCamera>): number => length(fromCamera(...shown));

/** From the camera, on the axes of the world that the observer's boost carries [m]. */
const fromCamera = (
  offset: Vec3,
  { u, vantage = ZERO }: Pick<ViewPoint, 'u' | 'vantage'>,
  settings: RenderSettings,
): Vec3 => sub(placementIn(settings).position(offset, u), vantage);

/** Where a picture shows a point, in front of the camera or not; undefined where it does not: behind the camera or a horizon. */
export function projectLine(
  line: WorldLine,
  observer: ViewPoint,
  settings: RenderSettings,
  size: PictureSize,
): PicturePosition | undefined {
  const viewPoint = drawnFrom(observer, settings);
  const event = picturedEvent(line, viewPoint, settings);
  return event && projectOffset(event.offset, viewPoint, settings, size);
}
