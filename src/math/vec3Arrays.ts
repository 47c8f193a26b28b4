import type { Vec3 } from './vec3.ts';

/** Applies `f` to each 3 numbers of `from` and writes 3 to `to`, which may be the same array. */
export function mapVectors(from: Float64Array, to: Float64Array, f: (v: Vec3) => Vec3): Float64Array {
  for (let i = 0; i + 2 < from.length; i += 3) to.set(f([from[i], from[i + 1], from[i + 2]]), i);
  return to;
}

/** Applies `f` to each 3 numbers of `from` and writes one to `to`. */
export function mapScalars(from: Float64Array, to: Float64Array, f: (v: Vec3) => number): Float64Array {
  for (let i = 0; 3 * i + 2 < from.length; i++) to[i] = f([from[3 * i], from[3 * i + 1], from[3 * i + 2]]);
  return to;
}
