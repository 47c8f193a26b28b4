import type { Mat4 } from '../math/mat4.ts';
import { gatherPoints } from './geometry.ts';
import { deformedNormals } from './normals.ts';
import { readSample, type StoredSample } from './storedNumbers.ts';
import { transformedNormals, transformedPoints } from './transformPoints.ts';

/**
 * The samples of a deforming mesh, left in their files: what it takes to make any one of them, and what had to be known of
 * all. Plain data: threads that it is sent to read for themselves.
 */
export interface StreamedPoints {
  readonly samples: readonly StreamedSample[];
  /** Of the file's points, the one that each vertex of the mesh is. */
  readonly pointOfVertex: Uint32Array;
  readonly shading: StreamedShading;
  readonly facts: PointFacts;
}

export interface StreamedSample {
  readonly points: StoredSample;
  /** From the file's axes and units to the world's, from the motion's origin. */
  readonly matrix: Mat4;
}

/** Where normals come from: the file, sample by sample, or the faces, within the smoothing groups (normals.ts). */
export type StreamedShading =
  | { readonly kind: 'stored'; readonly normals: readonly StoredSample[] }
  | { readonly kind: 'faces'; readonly indices: Uint32Array; readonly groups: Uint32Array };

/** What is known of every sample without reading it again. Places are from the motion's origin [m]. */
export interface PointFacts {
  /** Of each sample: its box, least x y z, greatest x y z. */
  readonly boxes: Float64Array;
  /** Of each sample: of the sphere round the middle of its box. */
  readonly radii: Float64Array;
  /** Of each piece between samples: the greatest speed [m/s], and which vertex has it. */
  readonly speeds: Float64Array;
  readonly fastest: Uint32Array;
  /** The first sample with a number that is not finite; −1 where there is none. */
  readonly broken: number;
}

/** How to make samples, before anything is known of them. */
export type PointRecipe = Omit<StreamedPoints, 'facts'>;

/** The points of sample k, 3 numbers per vertex, world-oriented, from the motion's origin [m]. */
export function makePoints({ samples, pointOfVertex }: PointRecipe, k: number): Float32Array {
  const { points, matrix } = samples[k];
  return transformedPoints(gatherPoints(readSample(points), pointOfVertex), matrix);
}

/** Their normals, unit. */
export function makeNormals({ samples, pointOfVertex, shading }: PointRecipe, k: number): Float32Array {
  const { points, matrix } = samples[k];
  const own = (sample: StoredSample): Float32Array => gatherPoints(readSample(sample), pointOfVertex);
  const normals =
    shading.kind === 'stored' ? own(shading.normals[k]) : deformedNormals(own(points), shading.indices, shading.groups);
  return transformedNormals(normals, matrix);
}

/** One vertex of sample k alone: three numbers are read. */
export function makePoint({ samples, pointOfVertex }: PointRecipe, k: number, vertex: number): Float32Array {
  const { points, matrix } = samples[k];
  return transformedPoints(Float32Array.from(readSample(points, 3 * pointOfVertex[vertex], 3)), matrix);
}

/** Samples that were made lately. */
class MadeSamples {
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
let made = new MadeSamples(SAMPLE_MEMORY);

/** Gives this thread so much memory for samples [bytes], and forgets those that it has. */
export function keepSamplesIn(bytes: number): void {
  made = new MadeSamples(bytes);
}

/** As `makePoints`, kept for a while: not to be written to. */
export const streamedPoints = (points: StreamedPoints, k: number): Float32Array => made.get(points, k, makePoints);

/** As `makeNormals`, kept for a while. */
export const streamedNormals = (points: StreamedPoints, k: number): Float32Array => made.get(points, k, makeNormals);
