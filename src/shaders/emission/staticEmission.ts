import { vec4 } from 'three/tsl';
import { coneOffset } from '../kinematics/coneOffset.ts';
import type { Vec3, Vec4, VertexEvent } from '../types.ts';

/**
 * Emission event of a vertex at rest at `offset` [m] from the anchor (d_c, R).
 * @example
 * import { vec3, vec4 } from 'three/tsl';
 * // A vertex 0.5 m beside an anchor that is seen 4 m ahead.
 * const { dx, s } = staticEmission(vec4(0, 0, -4, 4), vec3(0.5, 0, 0));
 */
export function staticEmission(anchor: Vec4, offset: Vec3): VertexEvent {
  return { dx: anchor.xyz.add(offset), s: coneOffset(anchor, offset).negate(), velocity: vec4(0, 0, 0, 1) };
}
