import { abs, dot, Fn, float, length, max, min, select, sqrt, vec4 } from 'three/tsl';
import type { Vec4 } from './types.ts';

/** Of a length in f32, relative; some roundings. */
const NOISE = 5e-7;

/**
 * The emission event of a point that moves uniformly and passes `event` = (Δx, c(t − t_o)), which is near the past light cone but not on it, as
 * what is interpolated between vertices: τ = q/(b − √(b² + (1 − v²)q)) later, q = |Δx|² − s², b = s − Δx·v ≤ 0. `velocity` = (v, 1 − v²).
 * What f32 cannot tell from the cone is left where it is: close to c, b is nearly 0, and the noise of q would carry the event far.
 */
export const ontoLightCone = Fn(
  ([event, velocity]: [Vec4, Vec4]): Vec4 => {
    const r = length(event.xyz).toVar();
    const beside = r.add(event.w).toVar();
    const q = select(abs(beside).lessThan(r.mul(NOISE)), float(0), beside.mul(r.sub(event.w))).toVar();
    const b = event.w.sub(dot(event.xyz, velocity.xyz)).toVar();
    const root = sqrt(max(b.mul(b).add(velocity.w.mul(q)), 0));
    const later = q.div(min(b.sub(root), -1e-30));
    const dx = event.xyz.add(velocity.xyz.mul(later)).toVar();
    return vec4(dx, length(dx).negate());
  },
  { event: 'vec4', velocity: 'vec4', return: 'vec4' },
);
