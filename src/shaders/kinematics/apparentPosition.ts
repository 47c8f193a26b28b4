import { cross, dot, Fn, length, max, select } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';

/**
 * Apparent position, in the observer's frame, of a point that emitted at Δx (world frame):
 * p∥′ = γp∥ + |u| r, transverse part unchanged; |Δx′| = D_o r. Behind the observer in conjugate form (|u×Δx|² − p∥²)/(|u| r − γp∥).
 * `dx` [m]; `u` = γβ of the observer. docs/physics.md §3.3.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * // At 0.6 c, what is 3 m ahead appears 6 m away.
 * const apparent = apparentPosition(vec3(0, 0, 3), vec3(0, 0, 0.75), float(1.25));
 */
export const apparentPosition = Fn(
  ([dx, u, gamma]: [Vec3, Vec3, Float]) => {
    const r = length(dx).toVar();
    const w = length(u).toVar();
    const axis = u.div(max(w, 1e-20)).toVar();
    const along = dot(axis, dx).toVar();
    const across = cross(u, dx).toVar();
    const behind = dot(across, across)
      .sub(along.mul(along))
      .div(w.mul(r).sub(gamma.mul(along)));
    const boosted = select(along.lessThan(0), behind, gamma.mul(along).add(w.mul(r)));
    // Orthogonalized twice, because a rounding error along the axis would be amplified by γ behind the observer.
    const rest = dx.sub(axis.mul(along)).toVar();
    return rest.sub(axis.mul(dot(axis, rest))).add(axis.mul(boosted));
  },
  { dx: 'vec3', u: 'vec3', gamma: 'float', return: 'vec3' },
);
