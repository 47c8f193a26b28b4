import { abs, float, floor, normalize, select, vec2, vec3 } from 'three/tsl';
import type { SampledPointsMotion } from '../scene/types.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import { FloatTable } from './floatTable.ts';

/** Texels that one object's samples may take: 256 MiB. */
const BUDGET = 2 ** 24;

/**
 * The samples of a deforming mesh on the GPU: a texel per vertex and sample, its place relative to the motion's origin [m] and its
 * normal, octahedral in 2 × 12 bits of the fourth float. All samples where they fit, else the ones around the span that is looked at.
 */
export class PointStore {
  readonly table = new FloatTable(4096);
  /** Of cubic motion, by the same places: (velocity [m/s], 0). */
  readonly velocities: FloatTable | undefined;
  readonly vertices: number;
  private readonly motion: SampledPointsMotion;
  private readonly meshNormals: Float32Array;
  /** How many samples fit. */
  readonly capacity: number;
  private first = -1;

  constructor(motion: SampledPointsMotion, meshNormals: Float32Array) {
    this.motion = motion;
    this.meshNormals = meshNormals;
    this.vertices = meshNormals.length / 3;
    this.velocities = motion.velocities && new FloatTable(4096);
    const perVertex = this.velocities ? 2 : 1;
    const most = Math.floor(BUDGET / (perVertex * Math.max(1, this.vertices)));
    this.capacity = Math.max(2, Math.min(motion.times.length, most));
  }

  /** Makes samples [first, first + count) resident and tells which sample is first in the table. */
  hold(first: number, count: number): number {
    const held = this.first >= 0 && first >= this.first && first + count <= this.first + this.capacity;
    if (held) return this.first;
    const spare = Math.max(0, this.capacity - count);
    this.first = Math.max(0, Math.min(first - (spare >> 1), this.motion.times.length - this.capacity));
    this.fill();
    return this.first;
  }

  private fill(): void {
    this.table.reserve(this.capacity * this.vertices);
    const out = this.table.values;
    for (let k = 0; k < this.capacity; k++) {
      const points = this.motion.points[this.first + k];
      const normals = this.motion.normals?.[this.first + k] ?? this.meshNormals;
      for (let i = 0; i < this.vertices; i++) {
        const at = 4 * (k * this.vertices + i);
        out[at] = points[3 * i];
        out[at + 1] = points[3 * i + 1];
        out[at + 2] = points[3 * i + 2];
        out[at + 3] = packNormal(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
      }
    }
    this.table.upload();
    this.fillVelocities();
  }

  private fillVelocities(): void {
    const { velocities, motion } = this;
    if (!velocities) return;
    velocities.reserve(this.capacity * this.vertices);
    for (let k = 0; k < this.capacity; k++) {
      const from = motion.velocities?.[this.first + k] ?? new Float32Array(3 * this.vertices);
      for (let i = 0; i < this.vertices; i++)
        for (let axis = 0; axis < 3; axis++) velocities.values[4 * (k * this.vertices + i) + axis] = from[3 * i + axis];
    }
    velocities.upload();
  }

  dispose(): void {
    this.table.dispose();
    this.velocities?.dispose();
  }
}

/** Steps per octahedral axis; their square is exact in f32. */
const NORMAL_STEPS = 4096;

/** A unit normal on the octahedron |x| + |y| + |z| = 1, the lower half folded out (Meyer et al. 2010), as one exact f32 integer. */
export function packNormal(x: number, y: number, z: number): number {
  const l = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
  const [a, b] = [x / l, y / l];
  const [p, q] = z >= 0 ? [a, b] : [(1 - Math.abs(b)) * Math.sign(a || 1), (1 - Math.abs(a)) * Math.sign(b || 1)];
  const step = (v: number) => Math.round((v * 0.5 + 0.5) * (NORMAL_STEPS - 1));
  return step(p) * NORMAL_STEPS + step(q);
}

/** The inverse of `packNormal`. */
export function unpackNormal(packed: Float): Vec3 {
  const high = floor(packed.div(NORMAL_STEPS)).toVar();
  const low = packed.sub(high.mul(NORMAL_STEPS));
  const p = vec2(high, low)
    .mul(2 / (NORMAL_STEPS - 1))
    .sub(1)
    .toVar();
  const z = float(1).sub(abs(p.x)).sub(abs(p.y)).toVar();
  const sign = (v: Float): Float => select(v.greaterThanEqual(0), float(1), float(-1));
  const x = select(z.greaterThanEqual(0), p.x, abs(p.y).oneMinus().mul(sign(p.x)));
  const y = select(z.greaterThanEqual(0), p.y, abs(p.x).oneMinus().mul(sign(p.y)));
  return normalize(vec3(x, y, z));
}
