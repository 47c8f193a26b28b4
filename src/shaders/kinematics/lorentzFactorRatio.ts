import { cross, dot, Fn, select } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../types.ts';

/**
 * γ(1 − β·v) = γ − u·v: the relative Lorentz factor of observer and source divided by the source's own; in conjugate form
 * (1 + u²(1 − v²) + |u×v|²)/(γ + u·v) where u·v > 0. `u` = γβ of the observer; `velocity` = (v, 1 − v²). docs/physics.md §5.2.
 */
export const lorentzFactorRatio = Fn(
  ([u, gamma, velocity]: [Vec3, Float, Vec4]): Float => {
    const along = dot(u, velocity.xyz).toVar();
    const across = cross(u, velocity.xyz).toVar();
    const together = dot(u, u).mul(velocity.w).add(dot(across, across)).add(1).div(gamma.add(along));
    return select(along.greaterThan(0), together, gamma.sub(along));
  },
  { u: 'vec3', gamma: 'float', velocity: 'vec4', return: 'float' },
);
