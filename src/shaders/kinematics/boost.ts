import { dot, Fn, vec4 } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../types.ts';

/**
 * World → the frame that moves with `u` = γβ: ct′ = γ ct − u·x, x′ = x + [u·x/(γ + 1) − ct] u. `X` = (x, ct). docs/physics.md §2.2.
 * @example
 * import { float, vec3, vec4 } from 'three/tsl';
 * const event = boost(vec4(5, 0, 0, 0), vec3(0.75, 0, 0), float(1.25)); // x′ = 6.25 m, ct′ = −3.75 m
 */
export const boost = Fn(
  ([X, u, gamma]: [Vec4, Vec3, Float]) => {
    const along = dot(u, X.xyz).toVar();
    const step = along.div(gamma.add(1)).sub(X.w);
    return vec4(X.xyz.add(u.mul(step)), gamma.mul(X.w).sub(along));
  },
  { X: 'vec4', u: 'vec3', gamma: 'float', return: 'vec4' },
);
