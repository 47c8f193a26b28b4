import { abs, cross, dot, Fn, float, length, max, min, select, sqrt, vec4 } from 'three/tsl';
import type { Vec4 } from '../types.ts';

/** Relative rounding error of a length in f32 after some operations. */
const NOISE = 5e-7;

/**
 * The emission event of a point that moves uniformly through `event` = (Δx, c(t − t_o)), which is near the past light cone but not on it, as
 * values interpolated between vertices are: τ = q/(b − √(b² + (1 − v²)q)) later, q = |Δx|² − s², b = s − Δx·v ≤ 0. `velocity` = (v, 1 − v²).
 * b is computed from |Δx| + Δx·v, in conjugate form where the point approaches. An event that f32 cannot distinguish from one on the cone is unchanged:
 * close to c, b is nearly 0, and rounding errors of q would move it far. docs/physics.md §4.10.
 * @example
 * import { vec4 } from 'three/tsl';
 * // An event interpolated between two vertices, 1 mm of light off the cone.
 * const event = ontoLightCone(vec4(0, 0, -4, -4.001), vec4(0.6, 0, 0, 0.64));
 */
export const ontoLightCone = Fn(
  ([event, velocity]: [Vec4, Vec4]): Vec4 => {
    const dx = event.xyz.toVar();
    const r = length(dx).toVar();
    const beside = r.add(event.w).toVar();
    const along = dot(dx, velocity.xyz).toVar();
    const across = cross(dx, velocity.xyz).toVar();
    const approaching = r
      .mul(r)
      .mul(velocity.w)
      .add(dot(across, across))
      .div(max(r.sub(along), 1e-30));
    const b = beside.sub(select(along.lessThan(0), approaching, r.add(along))).toVar();
    const q = select(abs(beside).lessThan(r.mul(NOISE)), float(0), beside.mul(r.sub(event.w))).toVar();
    const root = sqrt(max(b.mul(b).add(velocity.w.mul(q)), 0));
    const seen = dx.add(velocity.xyz.mul(q.div(min(b.sub(root), -1e-30)))).toVar();
    return vec4(seen, length(seen).negate());
  },
  { event: 'vec4', velocity: 'vec4', return: 'vec4' },
);
