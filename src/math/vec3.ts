/** A vector of three f64 numbers. Functions return new vectors and never change their arguments. */
export type Vec3 = readonly [x: number, y: number, z: number];

export const ZERO: Vec3 = [0, 0, 0];

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
/** a + s b */
export const addScaled = (a: Vec3, b: Vec3, s: number): Vec3 => [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s];
export const negate = (a: Vec3): Vec3 => [-a[0], -a[1], -a[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
/** |a|, without overflow or underflow on the way. */
export const length = (a: Vec3): number => norm(a[0], a[1], a[2]);
export const distance = (a: Vec3, b: Vec3): number => norm(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
/** √(x² + y² + z²). Math.hypot takes ten times as long and is called only where the squares would overflow or underflow. */
export function norm(x: number, y: number, z: number): number {
  const square = x * x + y * y + z * z;
  return square > 1e-280 && square < 1e300 ? Math.sqrt(square) : Math.hypot(x, y, z);
}
/** a/|a|, or `fallback` where |a| = 0. */
export const normalize = (a: Vec3, fallback: Vec3 = ZERO): Vec3 => {
  const l = length(a);
  return l > 0 ? [a[0] / l, a[1] / l, a[2] / l] : fallback;
};
/** (1 − s) a + s b */
export const lerp = (a: Vec3, b: Vec3, s: number): Vec3 => [
  a[0] + (b[0] - a[0]) * s,
  a[1] + (b[1] - a[1]) * s,
  a[2] + (b[2] - a[2]) * s,
];
