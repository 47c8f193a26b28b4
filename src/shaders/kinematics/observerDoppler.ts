import { cross, dot, Fn, length, max, select } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';

/**
 * D_o = γ(1 + β·n) of a source at rest in the world, seen along Δx. Behind (u·Δx < 0) in the conjugate form
 * (r² + |u×Δx|²)/((γr − u·Δx) r), which holds in the backward cone. `dx` [m], `u` = γβ. γ where Δx = 0.
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
