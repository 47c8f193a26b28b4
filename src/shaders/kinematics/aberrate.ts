import { Fn, normalize } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';
import { apparentPosition } from './apparentPosition.ts';

/** The direction `n` (unit, observer → source, world frame) in the observer's frame. `u` = γβ of the observer. docs/physics.md §3.2. */
export const aberrate = Fn(([n, u, gamma]: [Vec3, Vec3, Float]) => normalize(apparentPosition(n, u, gamma)), {
  n: 'vec3',
  u: 'vec3',
  gamma: 'float',
  return: 'vec3',
});
