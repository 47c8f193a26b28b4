import type { Vec3 } from '../../math/vec3.ts';

/** X^μ = (ct, x, y, z), all components [m]. */
export type FourVector = readonly [ct: number, x: number, y: number, z: number];

/**
 * The four-vector with the time component ct and the spatial part x [m].
 * @example
 * fourVector(1, [2, 3, 4]); // [1, 2, 3, 4]
 */
export const fourVector = (ct: number, x: Vec3): FourVector => [ct, x[0], x[1], x[2]];
/**
 * The spatial part.
 * @example
 * spatial([1, 2, 3, 4]); // [2, 3, 4]
 */
export const spatial = (X: FourVector): Vec3 => [X[1], X[2], X[3]];

/**
 * A·B with the metric (−,+,+,+); the same in every inertial frame.
 * @example
 * minkowskiDot([2, 1, 0, 0], [2, 1, 0, 0]); // -3
 */
export const minkowskiDot = (A: FourVector, B: FourVector): number =>
  A[1] * B[1] + A[2] * B[2] + A[3] * B[3] - A[0] * B[0];

/**
 * The interval (B − A)·(B − A) = (r − cΔt)(r + cΔt) [m²]: negative if timelike, 0 if null, positive if spacelike.
 * @example
 * interval([0, 0, 0, 0], [5, 3, 0, 0]); // -16 m²: timelike
 * interval([0, 0, 0, 0], [5, 3, 4, 0]); // 0 m²: a flash of light goes from one to the other
 */
export function interval(A: FourVector, B: FourVector): number {
  const r = Math.hypot(B[1] - A[1], B[2] - A[2], B[3] - A[3]);
  const ct = B[0] - A[0];
  return (r - ct) * (r + ct);
}
