import { cross, dot, Fn, max, select, sqrt } from 'three/tsl';
import type { Float, Vec4 } from '../types.ts';

/**
 * Time after the event `start` at which a point that continues from there with constant velocity v crosses the observer's past light cone:
 * the smaller root of (1 − v²)s² − 2Us + q = 0 with d, T from the observer to `start` (T > 0 before the observer),
 * U = T + d·v, q = T² − d². For f32, q is computed from the anchor, U in conjugate form where the point approaches, and
 * U² − (1 − v²)q as (1 − v²)e² + (e·v)² with e = d + vT. docs/physics.md §4.3, §4.9.
 * `anchor` = (d_c, R) [m]; `velocity` = (v, 1 − v²); `start` = (x, y, z, t) relative to the anchor.
 */
export const linearEmission = Fn(
  ([anchor, velocity, start]: [Vec4, Vec4, Vec4]): Float => {
    const v = velocity.xyz.toVar();
    const d = anchor.xyz.add(start.xyz).toVar();
    const T = anchor.w.sub(start.w).toVar();
    const q = start.w
      .mul(start.w.sub(anchor.w.mul(2)))
      .sub(dot(start.xyz, anchor.xyz.mul(2).add(start.xyz)))
      .toVar();
    const along = dot(d, v).toVar();
    const across = cross(d, v).toVar();
    const approaching = q.add(dot(d, d).mul(velocity.w)).add(dot(across, across)).div(T.sub(along));
    const U = select(along.lessThan(0), approaching, T.add(along)).toVar();
    const e = d.add(v.mul(T)).toVar();
    const ev = U.sub(T.mul(velocity.w)).toVar();
    const root = sqrt(dot(e, e).mul(velocity.w).add(ev.mul(ev))).toVar();
    return select(U.greaterThan(0), q.div(max(U.add(root), 1e-30)), U.sub(root).div(velocity.w));
  },
  { anchor: 'vec4', velocity: 'vec4', start: 'vec4', return: 'float' },
);
