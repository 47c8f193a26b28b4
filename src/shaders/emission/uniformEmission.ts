import { vec4 } from 'three/tsl';
import type { Vec3, Vec4, VertexEvent } from '../types.ts';
import { linearEmission } from './linearEmission.ts';

/**
 * Emission event of a vertex that moves uniformly and is at `offset` [m] from the anchor (d_c, R) at the anchor's time.
 * `velocity` = (v, 1 − v²) of the object.
 * @example
 * import { vec3, vec4 } from 'three/tsl';
 * const { dx } = uniformEmission(vec4(0, 0, -4, 4), vec4(0.6, 0, 0, 0.64), vec3(0.5, 0, 0));
 */
export function uniformEmission(anchor: Vec4, velocity: Vec4, offset: Vec3): VertexEvent {
  const s = linearEmission(anchor, velocity, vec4(offset, 0)).toVar();
  return { dx: anchor.xyz.add(offset.add(velocity.xyz.mul(s))), s, velocity };
}
