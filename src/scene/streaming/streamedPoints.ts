import { type Mat4, multiply } from '../../math/mat4.ts';
import { gatherPoints } from '../mesh/makeMesh.ts';
import { deformedNormals } from '../mesh/normals.ts';
import { transformNormalsInPlace, transformPointsInPlace } from '../mesh/transformPoints.ts';
import { readSample, type StoredSample } from './storedNumbers.ts';
import type { PointRecipe, StreamedPoints } from './storedPoints.ts';

/** Reads the points of sample k: 3 numbers per vertex, world-oriented, relative to the motion's origin [m]. */
export function makePoints(recipe: PointRecipe, k: number): Float32Array {
  const { points, matrix } = recipe.samples[k];
  return transformPointsInPlace(filePoints(recipe, points), matrix);
}

/** Points of the vertices in the file's axes and units. */
function filePoints({ pointOfVertex, nonFiniteVertices }: PointRecipe, points: StoredSample): Float32Array {
  const gathered = gatherPoints(readSample(points), pointOfVertex);
  if (nonFiniteVertices)
    for (let i = 0; i < gathered.length; i++) if (nonFiniteVertices[Math.floor(i / 3)] === 1) gathered[i] = 0;
  return gathered;
}

/** The same points with vertices that are not finite at some sample kept at the file's origin. */
export function withoutNonFiniteVertices(points: StreamedPoints): StreamedPoints {
  const { nonFiniteVertices, ...statistics } = points.statistics;
  return nonFiniteVertices
    ? { ...points, nonFiniteVertices, statistics: { ...statistics, firstNonFinite: -1 } }
    : points;
}

/** Unit normals of sample k, as `makePoints`. */
export function makeNormals(recipe: PointRecipe, k: number): Float32Array {
  const { samples, pointOfVertex, shading } = recipe;
  const { points, matrix } = samples[k];
  const normals =
    shading.kind === 'stored'
      ? gatherPoints(readSample(shading.normals[k]), pointOfVertex)
      : deformedNormals(filePoints(recipe, points), shading.indices, shading.groups);
  return zeroNonFinite(transformNormalsInPlace(normals, matrix));
}

/** Replaces values that are not finite by 0. */
function zeroNonFinite(normals: Float32Array): Float32Array {
  for (let i = 0; i < normals.length; i++) if (!Number.isFinite(normals[i])) normals[i] = 0;
  return normals;
}

/** One vertex of sample k; reads three numbers only. */
export function makePoint(
  { samples, pointOfVertex, nonFiniteVertices }: PointRecipe,
  k: number,
  vertex: number,
): Float32Array {
  const { points, matrix } = samples[k];
  const own = nonFiniteVertices?.[vertex] === 1 ? [0, 0, 0] : readSample(points, 3 * pointOfVertex[vertex], 3);
  return transformPointsInPlace(Float32Array.from(own), matrix);
}

/** Applies a matrix without shear to all samples. New boxes bound the transformed old ones. */
export function transformStreamedPoints(points: StreamedPoints, linear: Mat4): StreamedPoints {
  const { samples, statistics } = points;
  const s = Math.hypot(linear[0], linear[4], linear[8]);
  const boxes = new Float64Array(statistics.boxes.length);
  for (let k = 0; k < samples.length; k++)
    boxes.set(transformBox(statistics.boxes.subarray(6 * k, 6 * k + 6), linear), 6 * k);
  const [radii, displacements] = [statistics.radii.map((r) => s * r), statistics.displacements.map((d) => s * d)];
  return {
    ...points,
    samples: samples.map((sample) => ({ ...sample, matrix: multiply(linear, sample.matrix) })),
    statistics: { ...statistics, boxes, radii, displacements },
  };
}

/** Bounding box of a transformed box: min and max corner. */
function transformBox(box: Float64Array, m: Mat4): number[] {
  const rows = [0, 1, 2].map((row) =>
    [0, 1, 2].map((k) => [m[4 * row + k] * box[k], m[4 * row + k] * box[3 + k]] as const),
  );
  const ends = (pick: (a: number, b: number) => number) =>
    rows.map((row) => row.reduce((sum, [a, b]) => sum + pick(a, b), 0));
  return [...ends(Math.min), ...ends(Math.max)];
}

/** The samples with the indices `order`, each translated by its own shift [m], three numbers each. */
export function translateStreamedPoints(
  points: StreamedPoints,
  order: readonly number[],
  shifts: ArrayLike<number>,
): StreamedPoints {
  const { samples, shading, statistics } = points;
  const shift = (k: number, axis: number): number => shifts[3 * k + axis];
  const boxes = order.flatMap((from, k) =>
    Array.from(statistics.boxes.subarray(6 * from, 6 * from + 6), (x, i) => x + shift(k, i % 3)),
  );
  /** The value of the original piece; 0 if piece k joins a sample to itself. */
  const originalValue = (values: ArrayLike<number>, k: number): number =>
    order[k] < order[k + 1] ? values[order[k]] : 0;
  const shiftChange = (k: number): number =>
    Math.hypot(...[0, 1, 2].map((axis) => shift(k + 1, axis) - shift(k, axis)));
  const pieces = { length: order.length - 1 };
  return {
    ...points,
    samples: order.map((from, k) => ({
      points: samples[from].points,
      matrix: samples[from].matrix.map((x, i) => (i < 12 && i % 4 === 3 ? x + shift(k, (i - 3) / 4) : x)),
    })),
    shading: shading.kind === 'stored' ? { ...shading, normals: order.map((from) => shading.normals[from]) } : shading,
    statistics: {
      ...statistics,
      boxes: Float64Array.from(boxes),
      radii: Float64Array.from(order, (from) => statistics.radii[from]),
      displacements: Float64Array.from(pieces, (_, k) => originalValue(statistics.displacements, k) + shiftChange(k)),
      fastest: Uint32Array.from(pieces, (_, k) => originalValue(statistics.fastest, k)),
      firstNonFinite: statistics.firstNonFinite < 0 ? -1 : order.indexOf(statistics.firstNonFinite),
    },
  };
}
