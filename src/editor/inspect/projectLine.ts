import { conjugate, rotate } from '../../math/quat.ts';
import { sub, ZERO } from '../../math/vec3.ts';
import { hypersurfaceOf } from '../../physics/worldLines/hypersurface.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { frustumOf } from '../../scene/view/lens.ts';
import type { PictureSize } from '../../scene/view/pictureViews.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { hypersurfaceChoice, placementIn } from '../../scene/views/views.ts';
import type { PicturePosition } from '../viewport/legend/legendState.ts';

/** Where a picture shows a point, in front of the camera or not; undefined where it does not: behind the camera or a horizon. */
export function projectLine(
  line: WorldLine,
  { u, orientation, lens, vantage, ...observer }: ViewPoint,
  settings: RenderSettings,
  { width, height }: PictureSize,
): PicturePosition | undefined {
  const event = hypersurfaceOf(hypersurfaceChoice(settings)).intersect(line, observer, u, settings.speedOfLight);
  if (!event) return undefined;
  const place = sub(placementIn(settings).position(event.offset, u), vantage ?? ZERO);
  const [x, y, z] = rotate(conjugate(orientation), place);
  if (!(z < 0)) return undefined;
  const { tanX, tanY, center } = frustumOf(lens, width, height);
  return [(1 + (x / -z - center[0]) / tanX) / 2, (1 - (y / -z - center[1]) / tanY) / 2];
}
