import { rotate } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { lensDirection } from '../../scene/view/lenses/lenses.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';

/** n′ of a point of the picture: unit, observer's frame, on the world's axes carried by the pure boost; undefined where the lens shows nothing. */
export function directionAt(
  { orientation, lens }: ViewPoint,
  x: number,
  y: number,
  width: number,
  height: number,
): Vec3 | undefined {
  const direction = lensDirection(lens, x, y, { width, height });
  return direction && rotate(orientation, direction);
}

/**
 * The ray in the direction n′.
 * @example
 * import { DEFAULT_SETTINGS, perspective } from 'slowlight/scene';
 * const atRest = {
 *   t: 0,
 *   position: [0, 0, 0],
 *   u: [0, 0, 0],
 *   orientation: [0, 0, 0, 1],
 *   lens: perspective(1),
 * } as const;
 * rayToward(atRest, DEFAULT_SETTINGS, [1, 0, 0]); // { dt: -1, dx: [1, 0, 0] }
 */
export function rayToward({ t, position, u }: ViewPoint, settings: RenderSettings, n: Vec3): SpacetimeRay {
  const [dt, ...dx] = VIEWS[settings.view].rayToward(n, u, settings);
  return { t, x: position, dt, dx };
}
