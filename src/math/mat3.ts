import type { Vec3 } from './vec3.ts';

/** A 3×3 matrix, 9 numbers, row by row; it acts on column vectors (x′ = M x). */
export type Mat3 = readonly number[];

/**
 * The unit matrix.
 * @example
 * mat3.transform(mat3.IDENTITY, [1, 2, 3]); // [1, 2, 3]
 */
export const IDENTITY: Mat3 = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/**
 * The matrix product a b: acts as `b`, then `a`.
 * @example
 * mat3.multiply([2, 0, 0, 0, 2, 0, 0, 0, 2], [1, 2, 3, 4, 5, 6, 7, 8, 9]); // [2, 4, 6, 8, 10, 12, 14, 16, 18]
 */
export const multiply = (a: Mat3, b: Mat3): Mat3 => {
  const m = new Array<number>(9);
  for (let i = 0; i < 3; i++)
    for (let j = 0; j < 3; j++) m[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
  return m;
};
/**
 * M v, for a column vector v.
 * @example
 * // A quarter turn about z.
 * mat3.transform([0, -1, 0, 1, 0, 0, 0, 0, 1], [1, 0, 0]); // [0, 1, 0]
 */
export const transform = (m: Mat3, v: Vec3): Vec3 => [
  m[0] * v[0] + m[1] * v[1] + m[2] * v[2],
  m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
  m[6] * v[0] + m[7] * v[1] + m[8] * v[2],
];
/**
 * Mᵀ: rows become columns.
 * @example
 * mat3.transpose([1, 2, 3, 4, 5, 6, 7, 8, 9]); // [1, 4, 7, 2, 5, 8, 3, 6, 9]
 */
export const transpose = (m: Mat3): Mat3 => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];

/**
 * The cofactors of `m`: det(M) M⁻ᵀ, which transforms normals; defined for singular M too.
 * @example
 * // Normals of a shape that is stretched fourfold along x, up to their length.
 * mat3.cofactors([4, 0, 0, 0, 1, 0, 0, 0, 1]); // [1, 0, 0, 0, 4, 0, 0, 0, 4]
 */
export const cofactors = (m: Mat3): Mat3 => [
  m[4] * m[8] - m[5] * m[7],
  m[5] * m[6] - m[3] * m[8],
  m[3] * m[7] - m[4] * m[6],
  m[2] * m[7] - m[1] * m[8],
  m[0] * m[8] - m[2] * m[6],
  m[1] * m[6] - m[0] * m[7],
  m[1] * m[5] - m[2] * m[4],
  m[2] * m[3] - m[0] * m[5],
  m[0] * m[4] - m[1] * m[3],
];
/**
 * det M: the volume of the image of the unit cube, negative where M mirrors.
 * @example
 * mat3.determinant([2, 0, 0, 0, 3, 0, 0, 0, -1]); // -6
 */
export const determinant = (m: Mat3): number =>
  m[0] * (m[4] * m[8] - m[5] * m[7]) + m[1] * (m[5] * m[6] - m[3] * m[8]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
/**
 * M⁻¹, or undefined where det M = 0.
 * @example
 * mat3.invert([2, 0, 0, 0, 4, 0, 0, 0, 1]); // [0.5, 0, 0, 0, 0.25, 0, 0, 0, 1]
 * mat3.invert([1, 2, 3, 2, 4, 6, 0, 0, 1]); // undefined
 */
export const invert = (m: Mat3): Mat3 | undefined => {
  const d = determinant(m);
  return d === 0 || !Number.isFinite(d) ? undefined : transpose(cofactors(m)).map((x) => x / d);
};
/**
 * Whether M is diagonal with positive, finite elements: a scale along the axes.
 * @example
 * mat3.isPositiveDiagonal([2, 0, 0, 0, 2, 0, 0, 0, 5]); // true
 * mat3.isPositiveDiagonal([0, -1, 0, 1, 0, 0, 0, 0, 1]); // false
 */
export function isPositiveDiagonal([xx, xy, xz, yx, yy, yz, zx, zy, zz]: Mat3): boolean {
  if (xy !== 0 || xz !== 0 || yx !== 0 || yz !== 0 || zx !== 0 || zy !== 0) return false;
  return xx > 0 && yy > 0 && zz > 0 && xx + yy + zz < Infinity;
}
