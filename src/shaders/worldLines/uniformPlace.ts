import type { Vec3, Vec4, WorldLineAt } from '../types.ts';

/**
 * World line of a vertex in uniform motion (or at rest), at `offset` [m] from the anchor at its time; `velocity` = (v, 1 − v²).
 * @example
 * import { float, vec3, vec4 } from 'three/tsl';
 * const { x } = uniformPlace(vec4(0.6, 0, 0, 0.64), vec3(0.5, 0, 0))(float(2));
 */
export const uniformPlace =
  (velocity: Vec4, offset: Vec3): WorldLineAt =>
  (time) => ({ x: offset.add(velocity.xyz.mul(time)).toVar(), velocity });
