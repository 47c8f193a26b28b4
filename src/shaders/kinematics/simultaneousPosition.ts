import { dot, Fn, length, max } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';

/**
 * Observer-frame position of an event that is simultaneous with the observer's (Δt′ = 0) and lies at Δx in the world:
 * Δx′ = Δx − γ/(γ+1)(β·Δx)β: p∥ divided by γ, transverse part unchanged. `dx` [m]; `u` = γβ of the observer. docs/physics.md §5.5.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * // At 0.6 c, what is 5 m ahead in the world is 4 m ahead now.
 * const now = simultaneousPosition(vec3(5, 0, 0), vec3(0.75, 0, 0), float(1.25));
 */
export const simultaneousPosition = Fn(
  ([dx, u, gamma]: [Vec3, Vec3, Float]) => {
    const axis = u.div(max(length(u), 1e-20)).toVar();
    const along = dot(axis, dx).toVar();
    return dx.sub(axis.mul(along)).add(axis.mul(along.div(gamma)));
  },
  { dx: 'vec3', u: 'vec3', gamma: 'float', return: 'vec3' },
);
