import { conjugate, rotate } from '../../math/quat.ts';
import { sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { hypersurfaceOf } from '../../physics/worldLines/hypersurface.ts';
import type { SimultaneousEvent } from '../../physics/worldLines/slice.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { frustumOf } from '../../scene/view/lens.ts';
import type { PictureSize } from '../../scene/view/pictureViews.ts';
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
  { u, orientation, lens, vantage = ZERO }: Omit<ViewPoint, 't' | 'position'>,
  settings: RenderSettings,
  { width, height }: PictureSize,
): PicturePosition | undefined {
  const place = sub(placementIn(settings).position(offset, u), vantage);
  const [x, y, z] = rotate(conjugate(orientation), place);
  if (!(z < 0)) return undefined;
  const { tanX, tanY, center } = frustumOf(lens, width, height);
  return [(1 + (x / -z - center[0]) / tanX) / 2, (1 - (y / -z - center[1]) / tanY) / 2];
}

/** Where a picture shows a point, in front of the camera or not; undefined where it does not: behind the camera or a horizon. */
export function projectLine(
  line: WorldLine,
  viewPoint: ViewPoint,
  settings: RenderSettings,
  size: PictureSize,
): PicturePosition | undefined {
  const event = picturedEvent(line, viewPoint, settings);
  return event && projectOffset(event.offset, viewPoint, settings, size);
}
