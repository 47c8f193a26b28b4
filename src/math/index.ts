/**
 * Vectors, matrices, quaternions, roots and seeded random numbers, in 64-bit arithmetic. Vectors are columns (x′ = M
 * x), matrices arrays row by row.
 *
 * @module slowlight/math
 */

export type { Mat3 } from './mat3.ts';
/** 3×3 matrices. */
export * as mat3 from './mat3.ts';
export type { Mat4, RigidPose } from './mat4.ts';
/** 4×4 matrices, for poses and Lorentz transformations. */
export * as mat4 from './mat4.ts';
export type { Quat } from './quat.ts';
/** Quaternions, for rotations. */
export * as quat from './quat.ts';
export { type Random, random } from './random.ts';
export { bisect, brent, safeguardedNewton } from './roots.ts';
export type { Vec3 } from './vec3.ts';
/** Vectors in space. */
export * as vec3 from './vec3.ts';
