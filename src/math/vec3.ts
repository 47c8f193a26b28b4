/** A vector of three f64 numbers. Functions return new vectors and never change their arguments. */
export type Vec3 = readonly [x: number, y: number, z: number];

/**
 * The zero vector.
 * @example
 * vec3.length(vec3.ZERO); // 0
 */
export const ZERO: Vec3 = [0, 0, 0];

/**
 * a + b
 * @example
 * vec3.add([1, 2, 3], [4, 5, 6]); // [5, 7, 9]
 */
export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
/**
 * a − b
 * @example
 * vec3.sub([4, 5, 6], [1, 2, 3]); // [3, 3, 3]
 */
export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/**
 * s a
 * @example
 * vec3.scale([1, 2, 3], 2); // [2, 4, 6]
 */
export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
/**
 * a + s b
 * @example
 * vec3.addScaled([1, 2, 3], [1, 0, 0], 10); // [11, 2, 3]
 */
export const addScaled = (a: Vec3, b: Vec3, s: number): Vec3 => [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s];
/**
 * −a
 * @example
 * vec3.negate([1, -2, 3]); // [-1, 2, -3]
 */
export const negate = (a: Vec3): Vec3 => [-a[0], -a[1], -a[2]];
/**
 * a · b
 * @example
 * vec3.dot([1, 2, 3], [4, 5, 6]); // 32
 */
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/**
 * a × b, right-handed.
 * @example
 * vec3.cross([1, 0, 0], [0, 1, 0]); // [0, 0, 1]
 */
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
/**
 * |a|, without overflow or underflow on the way.
 * @example
 * vec3.length([2, 3, 6]); // 7
 */
export const length = (a: Vec3): number => norm(a[0], a[1], a[2]);
/**
 * |a − b|
 * @example
 * vec3.distance([1, 1, 1], [3, 4, 7]); // 7
 */
export const distance = (a: Vec3, b: Vec3): number => norm(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
/**
 * √(x² + y² + z²). Math.hypot takes ten times as long and is called only where the squares would overflow or underflow.
 * @example
 * vec3.norm(3e200, 0, 4e200); // 5e200
 */
export function norm(x: number, y: number, z: number): number {
  const square = x * x + y * y + z * z;
  return square > 1e-280 && square < 1e300 ? Math.sqrt(square) : Math.hypot(x, y, z);
}
/**
 * a/|a|, or `fallback` where |a| = 0.
 * @example
 * vec3.normalize([0, 3, 4]); // [0, 0.6, 0.8]
 * vec3.normalize([0, 0, 0]); // [0, 0, 0]
 */
export const normalize = (a: Vec3, fallback: Vec3 = ZERO): Vec3 => {
  const l = length(a);
  return l > 0 ? [a[0] / l, a[1] / l, a[2] / l] : fallback;
};
/**
 * (1 − s) a + s b
 * @example
 * vec3.lerp([0, 0, 0], [10, 20, 30], 0.1); // [1, 2, 3]
 */
export const lerp = (a: Vec3, b: Vec3, s: number): Vec3 => [
  a[0] + (b[0] - a[0]) * s,
  a[1] + (b[1] - a[1]) * s,
  a[2] + (b[2] - a[2]) * s,
];
