import { rotate } from '../../math/quat.ts';
import { add, dot, ZERO } from '../../math/vec3.ts';
import { lensEye } from '../../scene/view/lenses/lenses.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';
import { directionAt, rayToward } from './lensRay.ts';
import { sightCurve } from './sightCurve.ts';

/**
 * The camera ray of the point (x, y) of a picture [px from its top left corner; the first pixel's centre is at (½, ½)]. Its `s` is the apparent
 * distance from the camera in the observer's frame [m], the depth in pictures. Undefined where the lens shows nothing, outside the circle of a fisheye. From a vantage, and with a
 * stereo lens, it has a `curve`. The solver setting, which is for comparisons in the rasterizer, is ignored. docs/physics.md §3.7, §10.5.
 * @example
 * import { DEFAULT_SETTINGS, perspective } from 'slowlight/scene';
 * const view = {
 *   t: 0,
 *   position: [0, 0, 0],
 *   u: [0, 0, -0.75],
 *   orientation: [0, 0, 0, 1],
 *   lens: perspective(Math.PI / 2),
 * } as const;
 * // The middle of a picture by an observer at 0.6 c: a metre of apparent distance is half a metre in the world.
 * cameraRay(view, DEFAULT_SETTINGS, 50, 50, 100, 100); // { t: 0, dt: -0.5, dx: [0, 0, -0.5] }
 */
export function cameraRay(
  view: ViewPoint,
  settings: RenderSettings,
  x: number,
  y: number,
  width: number,
  height: number,
): SpacetimeRay | undefined {
  const n = directionAt(view, x, y, width, height);
  if (!n) return undefined;
  const ray = rayToward(view, settings, n);
  const eye = lensEye(view.lens, x, y, { width, height });
  const vantage = eye ? add(view.vantage ?? ZERO, rotate(view.orientation, eye)) : view.vantage;
  return vantage && dot(vantage, vantage) > 0
    ? { ...ray, curve: sightCurve(view, vantage, n, settings, view.vantage ? 'vantage' : 'head') }
    : ray;
}
