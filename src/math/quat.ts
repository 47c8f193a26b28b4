import type { Mat3 } from './mat3.ts';
import { cross, dot, normalize, type Vec3 } from './vec3.ts';

/** A quaternion x i + y j + z k + w; of unit length where it represents a rotation. */
export type Quat = readonly [x: number, y: number, z: number, w: number];

/**
 * No rotation.
 * @example
 * quat.rotate(quat.IDENTITY, [1, 2, 3]); // [1, 2, 3]
 */
export const IDENTITY: Quat = [0, 0, 0, 1];

/**
 * Hamilton product a b: as rotations, first `b`, then `a`.
 * @example
 * const quarter = quat.fromAxisAngle([0, 0, 1], Math.PI / 2);
 * quat.rotationAngle(quat.multiply(quarter, quarter)); // 3.14159 rad
 */
export const multiply = (a: Quat, b: Quat): Quat => [
  a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
  a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
  a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
  a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
];
/**
 * The inverse of a rotation.
 * @example
 * const quarter = quat.fromAxisAngle([0, 0, 1], Math.PI / 2);
 * quat.multiply(quarter, quat.conjugate(quarter)); // [0, 0, 0, 1]
 */
export const conjugate = (q: Quat): Quat => [-q[0], -q[1], -q[2], q[3]];

/**
 * q v q⁻¹ = v + 2 w (q × v) + 2 q × (q × v), for a unit q.
 * @example
 * quat.rotate(quat.fromAxisAngle([0, 0, 1], Math.PI / 2), [1, 0, 0]); // [0, 1, 0]
 */
export function rotate(q: Quat, v: Vec3): Vec3 {
  const [x, y, z, w] = q;
  const tx = 2 * (y * v[2] - z * v[1]);
  const ty = 2 * (z * v[0] - x * v[2]);
  const tz = 2 * (x * v[1] - y * v[0]);
  return [v[0] + w * tx + y * tz - z * ty, v[1] + w * ty + z * tx - x * tz, v[2] + w * tz + x * ty - y * tx];
}

/**
 * q/|q|; the identity where |q| = 0.
 * @example
 * quat.normalizeQuat([0, 0, 3, 4]); // [0, 0, 0.6, 0.8]
 */
export function normalizeQuat(q: Quat): Quat {
  const l = Math.hypot(q[0], q[1], q[2], q[3]);
  return l > 0 ? [q[0] / l, q[1] / l, q[2] / l, q[3] / l] : IDENTITY;
}

/**
 * Right-handed rotation by `angle` [rad] about `axis` (any length but 0).
 * @example
 * quat.fromAxisAngle([0, 0, 5], Math.PI / 2); // [0, 0, 0.7071, 0.7071]
 */
export function fromAxisAngle(axis: Vec3, angle: number): Quat {
  const [x, y, z] = normalize(axis);
  const s = Math.sin(angle / 2);
  return [x * s, y * s, z * s, Math.cos(angle / 2)];
}

/**
 * The rotation angle of a unit quaternion [rad], 0 … π; accurate for tiny angles too.
 * @example
 * quat.rotationAngle(quat.fromAxisAngle([1, 1, 0], 0.3)); // 0.3 rad
 */
export const rotationAngle = (q: Quat): number => 2 * Math.atan2(Math.hypot(q[0], q[1], q[2]), Math.abs(q[3]));

/**
 * Constant angular speed along the shorter arc from `a` (s = 0) to `b` (s = 1).
 * @example
 * const halfTurn = quat.fromAxisAngle([0, 0, 1], Math.PI / 2);
 * quat.rotationAngle(quat.slerp(quat.IDENTITY, halfTurn, 0.5)); // 0.7854 rad
 */
export function slerp(a: Quat, b: Quat, s: number): Quat {
  const d = multiply(conjugate(a), b);
  const turn: Quat = d[3] < 0 ? [-d[0], -d[1], -d[2], -d[3]] : d;
  const axis: Vec3 = [turn[0], turn[1], turn[2]];
  return normalizeQuat(multiply(a, fromAxisAngle(axis, s * rotationAngle(turn))));
}

/**
 * The quaternion of a proper rotation matrix, from its largest component (Shepperd 1978), so that nothing is divided by the root of a small number.
 * @example
 * quat.fromMatrix([0, -1, 0, 1, 0, 0, 0, 0, 1]); // [0, 0, 0.7071, 0.7071]
 */
export function fromMatrix(m: Mat3): Quat {
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = m;
  const [x, y, z, w] = [1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz, 1 + xx + yy + zz];
  const most = Math.max(x, y, z, w);
  if (!(most > w)) return normalizeQuat([zy - yz, xz - zx, yx - xy, w]);
  if (x === most) return normalizeQuat([x, xy + yx, zx + xz, zy - yz]);
  if (y === most) return normalizeQuat([xy + yx, y, yz + zy, xz - zx]);
  return normalizeQuat([zx + xz, yz + zy, z, yx - xy]);
}

/**
 * The rotation matrix of a unit quaternion.
 * @example
 * quat.toMatrix(quat.fromAxisAngle([0, 0, 1], Math.PI / 2)); // [0, -1, 0, 1, 0, 0, 0, 0, 1]
 */
export function toMatrix(q: Quat): Mat3 {
  const [x, y, z, w] = q;
  return [
    1 - 2 * (y * y + z * z),
    2 * (x * y - z * w),
    2 * (x * z + y * w),
    2 * (x * y + z * w),
    1 - 2 * (x * x + z * z),
    2 * (y * z - x * w),
    2 * (x * z - y * w),
    2 * (y * z + x * w),
    1 - 2 * (x * x + y * y),
  ];
}

/**
 * The rotation that takes one unit vector to another along the shortest arc; for opposite vectors half a turn about an axis perpendicular to them.
 * @example
 * quat.rotate(quat.shortestRotation([1, 0, 0], [0, 0, 1]), [1, 0, 0]); // [0, 0, 1]
 */
export function shortestRotation(from: Vec3, to: Vec3): Quat {
  const cosine = dot(from, to);
  if (cosine > 1 - 1e-15) return IDENTITY;
  const helper: Vec3 = Math.abs(from[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
  if (cosine < -1 + 1e-15) return fromAxisAngle(cross(cross(from, helper), from), Math.PI);
  const axis = cross(from, to);
  return fromAxisAngle(axis, Math.atan2(Math.hypot(...axis), cosine));
}
