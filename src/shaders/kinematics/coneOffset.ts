import { dot, Fn, length, max } from 'three/tsl';
import type { Vec3, Vec4 } from '../types.ts';

/**
 * |d_c + x| − R = (2 d_c·x + x²)/(|d_c + x| + R): how much farther away than the anchor the point `x` (relative to the anchor) is,
 * without a difference of two large numbers. An event at `x` and the time t is on the past light cone if this is −t,
 * and before it if this plus t is negative. `anchor` = (d_c, R) [m]. docs/physics.md §4.9.
 */
export const coneOffset = Fn(
  ([anchor, x]: [Vec4, Vec3]) =>
    dot(x, anchor.xyz.mul(2).add(x)).div(max(length(anchor.xyz.add(x)).add(anchor.w), 1e-20)),
  { anchor: 'vec4', x: 'vec3', return: 'float' },
);
