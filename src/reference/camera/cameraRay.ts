import { rotate } from '../../math/quat.ts';
import { normalize, type Vec3 } from '../../math/vec3.ts';
import { frustumOf } from '../../scene/view/lens.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';

/**
 * The ray of the point (x, y) of a picture: pixels from its top left corner, the first pixel's centre at (½, ½). Its `s` is the distance
 * in the observer's frame [m], so that depths along it are those of the picture. Newton's steps are for comparing, so the solver is not asked.
 */
export function cameraRay(
  view: ViewPoint,
  settings: RenderSettings,
  x: number,
  y: number,
  width: number,
  height: number,
): SpacetimeRay {
  return rayToward(view, settings, directionAt(view, x, y, width, height));
}

/** n′ of a point of the picture: unit, observer's frame, on the world's axes carried by the pure boost. */
export function directionAt(
  { orientation, lens }: ViewPoint,
  x: number,
  y: number,
  width: number,
  height: number,
): Vec3 {
  const { tanY, aspect, center } = frustumOf(lens, width, height);
  const right = ((2 * x) / width - 1) * tanY * aspect + center[0];
  const up = (1 - (2 * y) / height) * tanY + center[1];
  return normalize(rotate(orientation, [right, up, -1]));
}

/** The ray of a direction n′. */
export function rayToward({ t, position, u }: ViewPoint, settings: RenderSettings, n: Vec3): SpacetimeRay {
  const [dt, ...dx] = VIEWS[settings.view].rayToward(n, u, settings);
  return { t, x: position, dt, dx };
}
