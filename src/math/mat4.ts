import * as mat3 from './mat3.ts';
import { closestRotation } from './polar.ts';
import * as quat from './quat.ts';
import type { Vec3 } from './vec3.ts';

/** A 4×4 matrix, 16 numbers, row by row; it acts on column vectors (x′ = M x), a translation is the last column. */
export type Mat4 = readonly number[];

/** x′ = position + orientation · x */
export interface RigidPose {
  /** The origin of the body's own frame, in the outer frame; of scenes [m]. */
  readonly position: Vec3;
  /** The rotation from the body's axes to the outer ones, of unit length. */
  readonly orientation: quat.Quat;
}

/**
 * The unit matrix.
 * @example
 * mat4.transformPoint(mat4.IDENTITY, [1, 2, 3]); // [1, 2, 3]
 */
export const IDENTITY: Mat4 = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/**
 * a b: first `b`, then `a`.
 * @example
 * // Turn about z, then move along x.
 * const turn = mat4.fromParts([0, -1, 0, 1, 0, 0, 0, 0, 1], [0, 0, 0]);
 * const move = mat4.fromParts(mat3.IDENTITY, [5, 0, 0]);
 * mat4.transformPoint(mat4.multiply(move, turn), [1, 0, 0]); // [5, 1, 0]
 */
export function multiply(a: Mat4, b: Mat4): Mat4 {
  const m = new Array<number>(16);
  for (let i = 0; i < 16; i += 4)
    for (let j = 0; j < 4; j++)
      m[i + j] = a[i] * b[j] + a[i + 1] * b[4 + j] + a[i + 2] * b[8 + j] + a[i + 3] * b[12 + j];
  return m;
}

/**
 * A uniform scale by `s` applied after M.
 * @example
 * mat4.transformPoint(mat4.scaledUniformly(mat4.fromParts(mat3.IDENTITY, [1, 0, 0]), 3), [0, 2, 0]); // [3, 6, 0]
 */
export const scaledUniformly = (m: Mat4, s: number): Mat4 => [
  s * m[0],
  s * m[1],
  s * m[2],
  s * m[3],
  s * m[4],
  s * m[5],
  s * m[6],
  s * m[7],
  s * m[8],
  s * m[9],
  s * m[10],
  s * m[11],
  m[12],
  m[13],
  m[14],
  m[15],
];

/**
 * Mᵀ: rows become columns.
 * @example
 * const m = mat4.fromParts(mat3.IDENTITY, [7, 8, 9]);
 * mat4.transpose(m).slice(12); // [7, 8, 9, 1]
 */
export function transpose(m: Mat4): Mat4 {
  const t = new Array<number>(16);
  for (let i = 0; i < 4; i++) for (let j = 0; j < 4; j++) t[4 * i + j] = m[4 * j + i];
  return t;
}

/**
 * M⁻¹ by Gauss–Jordan elimination with row pivoting, or undefined where M is singular.
 * @example
 * const move = mat4.fromParts(mat3.IDENTITY, [5, 0, 0]);
 * mat4.transformPoint(mat4.invert(move)!, [5, 1, 0]); // [0, 1, 0]
 */
export function invert(m: Mat4): Mat4 | undefined {
  const rows = [0, 1, 2, 3].map((i) => [...m.slice(4 * i, 4 * i + 4), ...IDENTITY.slice(4 * i, 4 * i + 4)]);
  for (let k = 0; k < 4; k++) {
    let pivot = k;
    for (let i = k + 1; i < 4; i++) if (Math.abs(rows[i][k]) > Math.abs(rows[pivot][k])) pivot = i;
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    const p = rows[k][k];
    if (p === 0 || !Number.isFinite(p)) return undefined;
    rows[k] = rows[k].map((x) => x / p);
    for (let i = 0; i < 4; i++) if (i !== k) rows[i] = rows[i].map((x, j) => x - rows[i][k] * rows[k][j]);
  }
  return rows.flatMap((r) => r.slice(4));
}

/**
 * M applied to a point; the last row is assumed to be 0 0 0 1.
 * @example
 * mat4.transformPoint(mat4.fromParts(mat3.IDENTITY, [5, 0, 0]), [1, 2, 3]); // [6, 2, 3]
 */
export const transformPoint = (m: Mat4, p: Vec3): Vec3 => [
  m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3],
  m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7],
  m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11],
];
/**
 * M applied to a direction, without its translation.
 * @example
 * mat4.transformVector(mat4.fromParts(mat3.IDENTITY, [5, 0, 0]), [1, 2, 3]); // [1, 2, 3]
 */
export const transformVector = (m: Mat4, v: Vec3): Vec3 => [
  m[0] * v[0] + m[1] * v[1] + m[2] * v[2],
  m[4] * v[0] + m[5] * v[1] + m[6] * v[2],
  m[8] * v[0] + m[9] * v[1] + m[10] * v[2],
];

/**
 * The upper left 3×3, which transforms directions.
 * @example
 * mat4.linearPart(mat4.fromParts([2, 0, 0, 0, 3, 0, 0, 0, 4], [5, 6, 7])); // [2, 0, 0, 0, 3, 0, 0, 0, 4]
 */
export const linearPart = (m: Mat4): mat3.Mat3 => [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];

/**
 * From a linear part and a translation.
 * @example
 * mat4.fromParts(mat3.IDENTITY, [5, 6, 7]).slice(0, 4); // [1, 0, 0, 5]
 */
export const fromParts = (l: mat3.Mat3, t: Vec3): Mat4 => [
  l[0],
  l[1],
  l[2],
  t[0],
  l[3],
  l[4],
  l[5],
  t[1],
  l[6],
  l[7],
  l[8],
  t[2],
  0,
  0,
  0,
  1,
];
/**
 * The matrix of x ↦ position + orientation · x.
 * @example
 * const pose = { position: [1, 0, 0], orientation: quat.fromAxisAngle([0, 0, 1], Math.PI / 2) } as const;
 * mat4.transformPoint(mat4.fromPose(pose), [1, 0, 0]); // [1, 1, 0]
 */
export const fromPose = (pose: RigidPose): Mat4 => fromParts(quat.toMatrix(pose.orientation), pose.position);

/**
 * M = T(position) · R(orientation) · S with a symmetric stretch S (scale and shear in the body's own frame). S is positive
 * where det M > 0; a mirror leaves one negative eigenvalue in S, so that R is always a proper rotation.
 * @example
 * const m = mat4.fromParts([0, -2, 0, 2, 0, 0, 0, 0, 2], [1, 0, 0]);
 * const { pose, stretch } = mat4.decomposeRigid(m);
 * pose.position; // [1, 0, 0]
 * quat.rotationAngle(pose.orientation); // 1.5708 rad
 * stretch; // [2, 0, 0, 0, 2, 0, 0, 0, 2]
 */
export function decomposeRigid(m: Mat4): { readonly pose: RigidPose; readonly stretch: mat3.Mat3 } {
  const linear = linearPart(m);
  const position: Vec3 = [m[3], m[7], m[11]];
  // Fast path: most transforms have no rotation.
  if (mat3.isPositiveDiagonal(linear)) return { pose: { position, orientation: quat.IDENTITY }, stretch: linear };
  const orientation = closestRotation(linear);
  const s = mat3.multiply(mat3.transpose(quat.toMatrix(orientation)), linear);
  const symmetric = s.map((x, i) => (x + s[3 * (i % 3) + Math.floor(i / 3)]) / 2);
  return { pose: { position, orientation }, stretch: symmetric };
}

/**
 * The pose in M = T R S for a stretch S whose inverse is known; undefined if R is not a proper rotation.
 * @example
 * const m = mat4.fromParts([2, 0, 0, 0, 2, 0, 0, 0, 2], [1, 0, 0]);
 * mat4.poseFromStretched(m, [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5]); // { position: [1, 0, 0], orientation: [0, 0, 0, 1] }
 */
export function poseFromStretched(m: Mat4, inverseStretch: mat3.Mat3): RigidPose | undefined {
  const turn = mat3.multiply(linearPart(m), inverseStretch);
  return isRotation(turn, 1e-13) ? { position: [m[3], m[7], m[11]], orientation: closestRotation(turn) } : undefined;
}

/**
 * Whether M is a rotation and a translation only: |MᵀM − 1| ≤ `tolerance` in every element, and det M > 0.
 * @example
 * mat4.isRigid(mat4.fromParts([0, -1, 0, 1, 0, 0, 0, 0, 1], [5, 0, 0])); // true
 * mat4.isRigid(mat4.fromParts([2, 0, 0, 0, 1, 0, 0, 0, 1], [0, 0, 0])); // false
 */
export function isRigid(m: Mat4, tolerance = 1e-9): boolean {
  return isRotation(linearPart(m), tolerance);
}

function isRotation(l: mat3.Mat3, tolerance: number): boolean {
  const isGram = (i: number, j: number): boolean =>
    Math.abs(l[i] * l[j] + l[3 + i] * l[3 + j] + l[6 + i] * l[6 + j] - (i === j ? 1 : 0)) <= tolerance;
  const areUnit = isGram(0, 0) && isGram(1, 1) && isGram(2, 2);
  return areUnit && isGram(0, 1) && isGram(0, 2) && isGram(1, 2) && mat3.determinant(l) > 0;
}
