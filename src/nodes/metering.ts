import { normalizeQuat, rotate } from '../math/quat.ts';
import { dot, normalize, type Vec3 } from '../math/vec3.ts';
import { gamma, velocity } from '../physics/boost.ts';
import type { ViewPoint } from '../scene/view.ts';

/** Directions across the picture, in each axis. */
const GRID = 5;

/**
 * By how many stops the picture of a world at rest gets brighter for its observer's velocity alone: the mean over the picture's
 * directions n′ of log₂ D⁴, D = 1/[γ(1 − β·n′)] (without aberration, of the world's directions n: D = γ(1 + β·n)). A light
 * meter that does not need the picture, so that the exposure is the same in every run. [EV]
 */
export function stopsOfMotion({ u, orientation, fovY }: ViewPoint, aspect: number, aberration: boolean): number {
  const beta = velocity(u);
  const g = gamma(u);
  const tangent = Math.tan(fovY / 2);
  const axes = normalizeQuat(orientation);
  let sum = 0;
  for (let i = 0; i < GRID; i++) {
    for (let j = 0; j < GRID; j++) {
      const ray: Vec3 = [place(i) * tangent * aspect, place(j) * tangent, -1];
      const n = rotate(axes, normalize(ray));
      sum += Math.log2(aberration ? 1 / (g * (1 - dot(beta, n))) : g * (1 + dot(beta, n)));
    }
  }
  return (4 * sum) / GRID ** 2;
}

/** −1 … 1, in the middle of each cell. */
const place = (i: number): number => (2 * i + 1) / GRID - 1;
