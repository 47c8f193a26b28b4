import type { CubicPointsMotion } from '../../../scene/motion/cubicPoints.ts';
import { isStreamed, pointsAt } from '../../../scene/streaming/samplePoints.ts';
import { makeNormals } from '../../../scene/streaming/streamedPoints.ts';
import type { SampledPointsMotion } from '../../../scene/types.ts';
import { packNormal } from '../../gpu/packNormal.ts';

/** Texels in a row of a sample table. */
export const ROW_TEXELS = 4096;

/** A source of a deforming mesh's samples as texels: four floats per vertex, place and packed normal, in whole rows. */
export interface PackedSamples {
  /** Returns sample k and forgets it; undefined while it is loading. */
  take(k: number): Float32Array<ArrayBuffer> | undefined;
  /** Cancels requests for samples outside [first, end). */
  setWindow(first: number, end: number): void;
  /** Whether samples load in the background once requested, so that prefetching helps. */
  readonly isAsync: boolean;
}

export const rowsOf = (vertices: number): number => Math.max(1, Math.ceil(vertices / ROW_TEXELS));

/** Samples that are packed on this thread. */
export class LocalSamples implements PackedSamples {
  readonly isAsync = false;
  private readonly motion: SampledPointsMotion;
  private readonly meshNormals: Float32Array;
  private readonly rows: Float32Array<ArrayBuffer>;

  constructor(motion: SampledPointsMotion, meshNormals: Float32Array) {
    this.motion = motion;
    this.meshNormals = meshNormals;
    this.rows = new Float32Array(4 * ROW_TEXELS * rowsOf(meshNormals.length / 3));
  }

  take(k: number): Float32Array<ArrayBuffer> {
    packSample(this.motion, k, this.meshNormals, this.rows);
    return this.rows;
  }

  setWindow(): void {}
}

/** Writes sample k of a motion as texels, from float `at` on. */
export function packSample(
  motion: Pick<SampledPointsMotion, 'points' | 'normals'>,
  k: number,
  meshNormals: Float32Array,
  out: Float32Array,
  at = 0,
): void {
  const points = pointsAt(motion, k);
  // These are used only here, so they are not cached.
  const normals = isStreamed(motion.points) ? makeNormals(motion.points, k) : (motion.normals?.[k] ?? meshNormals);
  for (let i = 0, to = at; i < points.length; i += 3, to += 4) {
    out[to] = points[i];
    out[to + 1] = points[i + 1];
    out[to + 2] = points[i + 2];
    out[to + 3] = packNormal(normals[i], normals[i + 1], normals[i + 2]);
  }
}

/** Writes the velocities at sample k as texels (velocity [m/s], 0), from float `at` on; returns `out`. */
export function packVelocities<T extends Float32Array>(
  { velocities }: CubicPointsMotion,
  k: number,
  out: T,
  at = 0,
): T {
  const from = velocities[k];
  for (let i = 0, to = at; i < from.length; i += 3, to += 4) {
    out[to] = from[i];
    out[to + 1] = from[i + 1];
    out[to + 2] = from[i + 2];
    out[to + 3] = 0;
  }
  return out;
}
