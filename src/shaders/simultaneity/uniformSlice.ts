import { dot } from 'three/tsl';
import { lorentzFactorRatio } from '../kinematics/lorentzFactorRatio.ts';
import type { Float, Vec3, Vec4, VertexEvent } from '../types.ts';

/**
 * The event of a uniformly moving (or resting) vertex on the observer's slice Δt′ = 0: s = u·o/(γ − u·v). `anchor` = (d_c, R) is an event
 * of the slice (its time is β·d_c); `velocity` = (v, 1 − v²); `offset` [m] from the anchor at its time. u = 0: the slice of world time. docs/physics.md §5.2.
 * @example
 * import { float, vec3, vec4 } from 'three/tsl';
 * const { dx } = uniformSlice(vec4(0, 0, -4, 4), vec4(0.6, 0, 0, 0.64), vec3(0.5, 0, 0), vec3(0.75, 0, 0), float(1.25));
 */
export function uniformSlice(anchor: Vec4, velocity: Vec4, offset: Vec3, u: Vec3, gamma: Float): VertexEvent {
  const s = dot(u, offset)
    .div(lorentzFactorRatio(u, gamma, velocity))
    .toVar();
  return { dx: anchor.xyz.add(offset.add(velocity.xyz.mul(s))), s, velocity };
}
