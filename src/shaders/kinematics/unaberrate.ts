import { Fn } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';
import { aberrate } from './aberrate.ts';

/** Inverse of `aberrate`: the world direction of the observed direction `nPrime` (unit). */
export const unaberrate = Fn(([nPrime, u, gamma]: [Vec3, Vec3, Float]) => aberrate(nPrime, u.negate(), gamma), {
  nPrime: 'vec3',
  u: 'vec3',
  gamma: 'float',
  return: 'vec3',
});
