import { Fn, normalize } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';
import { apparentPosition } from './apparentPosition.ts';

/**
 * The direction `n` (unit, observer → source, world frame) in the observer's frame. `u` = γβ of the observer. docs/physics.md §3.2.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * // At 0.8 c, u = 4/3 and γ = 5/3: what is abeam is seen in the direction (0.6, 0, 0.8).
 * const seen = aberrate(vec3(1, 0, 0), vec3(0, 0, 4 / 3), float(5 / 3));
 */
export const aberrate = Fn(([n, u, gamma]: [Vec3, Vec3, Float]) => normalize(apparentPosition(n, u, gamma)), {
  n: 'vec3',
  u: 'vec3',
  gamma: 'float',
  return: 'vec3',
});
