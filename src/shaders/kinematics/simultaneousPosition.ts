import { dot, Fn, length, max } from 'three/tsl';
import type { Float, Vec3 } from '../types.ts';

/**
 * Observer-frame position of an event that is simultaneous with the observer's (Δt′ = 0) and lies at Δx in the world:
 * Δx′ = Δx − γ/(γ+1)(β·Δx)β: p∥ divided by γ, transverse part unchanged. `dx` [m]; `u` = γβ of the observer. docs/physics.md §5.5.
 */
export const simultaneousPosition = Fn(
  ([dx, u, gamma]: [Vec3, Vec3, Float]) => {
    const axis = u.div(max(length(u), 1e-20)).toVar();
    const along = dot(axis, dx).toVar();
    return dx.sub(axis.mul(along)).add(axis.mul(along.div(gamma)));
  },
  { dx: 'vec3', u: 'vec3', gamma: 'float', return: 'vec3' },
);
