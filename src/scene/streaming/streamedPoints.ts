import { type Mat4, multiply } from '../../math/mat4.ts';
import { gatherPoints } from '../mesh/makeMesh.ts';
import { deformedNormals } from '../mesh/normals.ts';
import { transformNormalsInPlace, transformPointsInPlace } from '../mesh/transformPoints.ts';
import { readSample, type StoredSample } from './storedNumbers.ts';
import type { PointRecipe, StreamedPoints } from './storedPoints.ts';

/** The points of sample k, 3 numbers per vertex, world-oriented, from the motion's origin [m]. */
export function makePoints(recipe: PointRecipe, k: number): Float32Array {
  const { points, matrix } = recipe.samples[k];
  return transformPointsInPlace(filePoints(recipe, points), matrix);
}

/** In the file's axes and units. */
function filePoints({ pointOfVertex, nonFiniteVertices }: PointRecipe, points: StoredSample): Float32Array {
  const own = gatherPoints(readSample(points), pointOfVertex);
  if (nonFiniteVertices)
    for (let i = 0; i < own.length; i++) if (nonFiniteVertices[Math.floor(i / 3)] === 1) own[i] = 0;
  return own;
}

/** The same without the vertices that are nowhere at some sample. */
export function withoutNonFiniteVertices(points: StreamedPoints): StreamedPoints {
  const { nonFiniteVertices, ...facts } = points.statistics;
  return nonFiniteVertices ? { ...points, nonFiniteVertices, statistics: { ...facts, firstNonFinite: -1 } } : points;
}

/** Their normals, unit. */
export function makeNormals(recipe: PointRecipe, k: number): Float32Array {
  const { samples, pointOfVertex, shading } = recipe;
  const { points, matrix } = samples[k];
  const normals =
    shading.kind === 'stored'
      ? gatherPoints(readSample(shading.normals[k]), pointOfVertex)
      : deformedNormals(filePoints(recipe, points), shading.indices, shading.groups);
  return zeroNonFinite(transformNormalsInPlace(normals, matrix));
}

/** What is no number is 0: such a normal is none, as one of length 0. */
function zeroNonFinite(normals: Float32Array): Float32Array {
  for (let i = 0; i < normals.length; i++) if (!Number.isFinite(normals[i])) normals[i] = 0;
  return normals;
}

/** One vertex of sample k alone: three numbers are read. */
export function makePoint(
  { samples, pointOfVertex, nonFiniteVertices }: PointRecipe,
  k: number,
  vertex: number,
): Float32Array {
  const { points, matrix } = samples[k];
  const own = nonFiniteVertices?.[vertex] === 1 ? [0, 0, 0] : readSample(points, 3 * pointOfVertex[vertex], 3);
  return transformPointsInPlace(Float32Array.from(own), matrix);
}

/** Samples that were made lately. */
class SampleCache {
  private readonly made = new Map<string, Float32Array>();
  private readonly names = new WeakMap<PointRecipe, number>();
  private named = 0;
  private left: number;

  /** [bytes] */
  constructor(budget: number) {
    this.left = budget;
  }

  /** Those that were not asked for for the longest time give way. */
  get(points: PointRecipe, k: number, make: typeof makePoints): Float32Array {
    const name = this.names.get(points) ?? ++this.named;
    this.names.set(points, name);
    const key = `${make === makePoints ? 'points' : 'normals'} ${name} ${k}`;
    const found = this.made.get(key) ?? make(points, k);
    if (!this.made.delete(key)) this.left -= found.byteLength;
    this.made.set(key, found);
    for (const [oldest, { byteLength }] of this.made) {
      if (this.left >= 0 || this.made.size <= 2) break;
      this.made.delete(oldest);
      this.left += byteLength;
    }
    return found;
  }
}

/** For the samples of all streamed meshes, in each thread that reads them [bytes]. */
const SAMPLE_MEMORY = 128 * 2 ** 20;
let made = new SampleCache(SAMPLE_MEMORY);

/** Gives this thread so much memory for samples [bytes], and forgets those that it has. */
export function setSampleCacheSize(bytes: number): void {
  made = new SampleCache(bytes);
}

/** As `makePoints`, kept for a while: not to be written to. */
export const streamedPoints = (points: StreamedPoints, k: number): Float32Array => made.get(points, k, makePoints);

/** As `makeNormals`, kept for a while. */
export const streamedNormals = (points: StreamedPoints, k: number): Float32Array => made.get(points, k, makeNormals);

/** All samples turned and enlarged alike, by a matrix that does not shear. A box is that of the box that is turned. */
export function transformStreamedPoints(points: StreamedPoints, linear: Mat4): StreamedPoints {
  const { samples, statistics } = points;
  const s = Math.hypot(linear[0], linear[4], linear[8]);
  const boxes = new Float64Array(statistics.boxes.length);
  for (let k = 0; k < samples.length; k++)
    boxes.set(transformBox(statistics.boxes.subarray(6 * k, 6 * k + 6), linear), 6 * k);
  const [radii, ways] = [statistics.radii.map((r) => s * r), statistics.displacements.map((way) => s * way)];
  return {
    ...points,
    samples: samples.map((sample) => ({ ...sample, matrix: multiply(linear, sample.matrix) })),
    statistics: { ...statistics, boxes, radii, displacements: ways },
  };
}

/** Least and greatest corner of a box that has been turned. */
function transformBox(box: Float64Array, m: Mat4): number[] {
  const rows = [0, 1, 2].map((row) =>
    [0, 1, 2].map((k) => [m[4 * row + k] * box[k], m[4 * row + k] * box[3 + k]] as const),
  );
  const ends = (pick: (a: number, b: number) => number) =>
    rows.map((row) => row.reduce((sum, [a, b]) => sum + pick(a, b), 0));
  return [...ends(Math.min), ...ends(Math.max)];
}

/** Carried along: the samples of `order`, each moved by its own shift [m], three numbers each. */
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
  /** Of piece k of the old ones; none where a sample is there twice. */
  const before = (values: ArrayLike<number>, k: number): number => (order[k] < order[k + 1] ? values[order[k]] : 0);
  const carried = (k: number): number => Math.hypot(...[0, 1, 2].map((axis) => shift(k + 1, axis) - shift(k, axis)));
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
      displacements: Float64Array.from(pieces, (_, k) => before(statistics.displacements, k) + carried(k)),
      fastest: Uint32Array.from(pieces, (_, k) => before(statistics.fastest, k)),
      firstNonFinite: statistics.firstNonFinite < 0 ? -1 : order.indexOf(statistics.firstNonFinite),
    },
  };
}
