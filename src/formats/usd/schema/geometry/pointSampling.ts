import type { Mat4 } from '../../../../math/mat4.ts';
import type { Vec3 } from '../../../../math/vec3.ts';
import { boundingBox } from '../../../../scene/bounds/bounds.ts';
import { subsampleEvenly } from '../../../read/subsample.ts';

/** Points, 3 numbers each, transformed by a matrix. */
export const transformedPoints = (points: ArrayLike<number>, m: Mat4): Float64Array =>
  transformPointsInto(new Float64Array(points.length), points, m);

export function transformPointsInto(out: Float64Array, points: ArrayLike<number>, m: Mat4): Float64Array {
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    out[i] = m[0] * x + m[1] * y + m[2] * z + m[3];
    out[i + 1] = m[4] * x + m[5] * y + m[6] * z + m[7];
    out[i + 2] = m[8] * x + m[9] * y + m[10] * z + m[11];
  }
  return out;
}

/** Corners of the bounding box of points; the origin if none is finite. */
export function boxCorners(points: ArrayLike<number>): Vec3[] {
  const box = boundingBox(points);
  if (!box) return [[0, 0, 0]];
  const side = (i: number, k: number): number => ((i >> k) & 1 ? box.max : box.min)[k];
  return Array.from({ length: 8 }, (_, i): Vec3 => [side(i, 0), side(i, 1), side(i, 2)]);
}

/** Memory of a deforming mesh with `vectors` vectors of three f32 per vertex and time [bytes]. */
export const pointBytes = (times: number, vertices: number, vectors: number): number => times * vertices * 12 * vectors;

/** As many times as fit in `bytes`, evenly spaced, including the first and last. */
export function affordableTimes(times: Float64Array, perTime: number, bytes: number): Float64Array {
  return subsampleEvenly(times, Math.max(2, Math.floor(bytes / perTime)));
}

/** Vectors per vertex and time: position, normal, and a velocity for cubic interpolation. */
export const vectorsPerVertex = ({ cubic }: { readonly cubic: boolean }): number => (cubic ? 3 : 2);
