import { cross, dot, Fn, length, max, select } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';

/**
 * D_o = γ(1 + β·n) of a source at rest in the world, in the direction Δx. Where u·Δx < 0 in conjugate form
 * (r² + |u×Δx|²)/((γr − u·Δx) r), accurate in the backward cone. `dx` [m], `u` = γβ. γ for Δx = 0. docs/physics.md §3.4.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * // Towards a source at 0.6 c: D = 2.
 * const D = observerDoppler(vec3(0, 0, 4), vec3(0, 0, 0.75), float(1.25));
 */
export const observerDoppler = Fn(
  ([dx, u, gamma]: [Vec3, Vec3, Float]) => {
    const r = max(length(dx), 1e-20).toVar();
    const along = dot(u, dx).toVar();
    const across = cross(u, dx).toVar();
    const behind = r.mul(r).add(dot(across, across)).div(gamma.mul(r).sub(along).mul(r));
    return select(along.lessThan(0), behind, gamma.add(along.div(r)));
  },
  { dx: 'vec3', u: 'vec3', gamma: 'float', return: 'float' },
);
