import { Fn } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';
import { aberrate } from './aberrate.ts';

/**
 * Inverse of `aberrate`: the world direction of the observed direction `nPrime` (unit).
 * @example
 * import { float, vec3 } from 'three/tsl';
 * const direction = unaberrate(vec3(0.6, 0, 0.8), vec3(0, 0, 4 / 3), float(5 / 3));
 */
export const unaberrate = Fn(([nPrime, u, gamma]: [Vec3, Vec3, Float]) => aberrate(nPrime, u.negate(), gamma), {
  nPrime: 'vec3',
  u: 'vec3',
  gamma: 'float',
  return: 'vec3',
});
