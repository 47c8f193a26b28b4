import { floor, vec2 } from 'three/tsl';
import type { WebGPURenderer } from 'three/webgpu';
import { type CubicPointsMotion, isCubic } from '../../../scene/motion/cubicPoints.ts';
import { isStreamed } from '../../../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../../../scene/types.ts';
import type { Float, Vec3 } from '../../../shaders/types.ts';
import { FloatTable, RowUploader } from '../../gpu/floatTable.ts';
import { decodeOctahedral } from '../../gpu/octahedral.ts';
import { NORMAL_STEPS } from '../../gpu/packNormal.ts';
import { LocalSamples, type PackedSamples, packSample, packVelocities, ROW_TEXELS, rowsOf } from './packedSamples.ts';
import { SampleRing } from './sampleRing.ts';

/** Default limit of texels of one object's samples: 256 MiB. */
const DEFAULT_MAX_TEXELS = 2 ** 24;

/** How the samples of a deforming mesh are uploaded. */
export interface PointStoreOptions {
  /** Limit of texels of one object's samples. */
  readonly maxTexels?: number | undefined;
  /** Source of samples that are left in a file; by default samples are packed on this thread. */
  readonly samples?: PackedSamples | undefined;
}

/**
 * The samples of a deforming mesh on the GPU: a texel per vertex and sample, its place relative to the motion's origin [m] and its normal, octahedral in 2 ×
 * 12 bits of the fourth float. All samples in a row if they are in memory and fit; otherwise a ring buffer (sampleRing.ts) of those around the current
 * window, each in rows of its own, of which only new ones are uploaded.
 */
export class PointStore {
  readonly table = new FloatTable(ROW_TEXELS);
  /** Of cubic motion, at the same texels: (velocity [m/s], 0). */
  readonly velocities: FloatTable | undefined;
  /** Texels from one sample to the next. */
  readonly stride: number;
  /** Number of samples that fit. */
  readonly capacity: number;
  private readonly renderer: WebGPURenderer;
  private readonly samples: PackedSamples;
  private readonly ring: SampleRing | undefined;
  private readonly cubic: CubicPointsMotion | undefined;
  private readonly copy = new RowUploader();

  constructor(
    motion: SampledPointsMotion,
    meshNormals: Float32Array,
    renderer: WebGPURenderer,
    { maxTexels = DEFAULT_MAX_TEXELS, samples }: PointStoreOptions = {},
  ) {
    const vertices = meshNormals.length / 3;
    const { length } = motion.times;
    this.renderer = renderer;
    this.samples = samples ?? new LocalSamples(motion, meshNormals);
    this.cubic = isCubic(motion) ? motion : undefined;
    this.velocities = this.cubic && new FloatTable(ROW_TEXELS);
    const capacity = this.velocities ? maxTexels / 2 : maxTexels;
    if (!isStreamed(motion.points) && length * vertices <= capacity) {
      this.stride = vertices;
      this.capacity = length;
      this.fill(motion, meshNormals);
      return;
    }
    const rows = rowsOf(vertices);
    this.stride = ROW_TEXELS * rows;
    this.capacity = Math.max(2, Math.min(length, Math.floor(capacity / this.stride)));
    this.ring = new SampleRing(this.capacity, length);
    for (const table of this.tables()) table.allocateOnGpu(this.capacity * rows);
  }

  /** Sample k, once it is resident, begins at texel `stride` times this. */
  slot(k: number): number {
    return this.ring ? k % this.capacity : k;
  }

  /** Uploads samples [first, first + count); returns whether all of them are resident. */
  ensureResident(first: number, count: number): boolean {
    const { ring, samples } = this;
    if (!ring) return true;
    const { missing, prefetch } = ring.request(first, count);
    samples.setWindow(ring.first, ring.end);
    const resident = missing.filter((k) => this.upload(ring, k)).length === missing.length;
    if (samples.isAsync) for (const k of prefetch) this.upload(ring, k);
    return resident;
  }

  /** Frees the memory on the GPU of samples that are uploaded again as a whole when they are next read. */
  release(): void {
    if (!this.ring) for (const table of this.tables()) table.dispose();
  }

  private upload(ring: SampleRing, k: number): boolean {
    const rows = this.samples.take(k);
    if (!rows) return false;
    const row = (this.slot(k) * this.stride) / ROW_TEXELS;
    this.table.writeRows(this.renderer, row, rows, this.copy);
    // The rows have been copied, so their array can be reused.
    if (this.cubic) this.velocities?.writeRows(this.renderer, row, packVelocities(this.cubic, k, rows), this.copy);
    ring.markResident(k);
    return true;
  }

  private fill(motion: SampledPointsMotion, meshNormals: Float32Array): void {
    for (const table of this.tables()) table.reserve(this.capacity * this.stride);
    for (let k = 0; k < this.capacity; k++) {
      packSample(motion, k, meshNormals, this.table.values, 4 * this.stride * k);
      if (this.cubic && this.velocities) packVelocities(this.cubic, k, this.velocities.values, 4 * this.stride * k);
    }
    for (const table of this.tables()) table.upload();
  }

  private tables(): FloatTable[] {
    return this.velocities ? [this.table, this.velocities] : [this.table];
  }

  dispose(): void {
    for (const table of this.tables()) table.dispose();
    this.copy.dispose();
  }
}

/** The inverse of `packNormal`. */
export function unpackNormal(packed: Float): Vec3 {
  const high = floor(packed.div(NORMAL_STEPS)).toVar();
  const low = packed.sub(high.mul(NORMAL_STEPS));
  const p = vec2(high, low)
    .mul(2 / (NORMAL_STEPS - 1))
    .sub(1)
    .toVar();
  return decodeOctahedral(p);
}
