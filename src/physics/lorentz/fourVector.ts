import type { Vec3 } from '../../math/vec3.ts';

/** X^μ = (ct, x, y, z), all components [m]. */
export type FourVector = readonly [ct: number, x: number, y: number, z: number];

export const fourVector = (ct: number, x: Vec3): FourVector => [ct, x[0], x[1], x[2]];
/** The spatial part. */
export const spatial = (X: FourVector): Vec3 => [X[1], X[2], X[3]];

/** A·B with the metric (−,+,+,+); the same in every inertial frame. */
export const minkowskiDot = (A: FourVector, B: FourVector): number =>
  A[1] * B[1] + A[2] * B[2] + A[3] * B[3] - A[0] * B[0];

/** The interval (B − A)·(B − A) = (r − cΔt)(r + cΔt) [m²]: negative if timelike, 0 if null, positive if spacelike. */
export function interval(A: FourVector, B: FourVector): number {
  const r = Math.hypot(B[1] - A[1], B[2] - A[2], B[3] - A[3]);
  const ct = B[0] - A[0];
  return (r - ct) * (r + ct);
}
