import type { SampledPointsMotion } from '../../scene/types.ts';
import type { BatchArrays } from '../batches.ts';
import type { Window } from './polyline.ts';
import type { Lump } from './shown.ts';

/** Most triangles of a cluster. */
const CLUSTER = 128;

/** All clusters of one body in a batch: [first, end). */
export interface Run {
  /** Object id − 1. */
  readonly body: number;
  readonly first: number;
  readonly end: number;
}

/** A batch's triangles in runs of neighbours in the index buffer, each of one body. */
export class Clusters {
  /** First triangle of each cluster, and after the last one the number of triangles. */
  readonly starts: Uint32Array;
  readonly runs: readonly Run[];

  constructor({ indices, ids }: BatchArrays) {
    const triangles = indices.length / 3;
    const starts: number[] = [];
    const runs: Run[] = [];
    let body = -1;
    for (let t = 0; t < triangles; t++) {
      const owner = ids[2 * indices[3 * t]];
      if (owner !== body) runs.push({ body: owner, first: starts.length, end: starts.length });
      if (owner !== body || t - starts[starts.length - 1] >= CLUSTER) {
        starts.push(t);
        const run = runs[runs.length - 1];
        runs[runs.length - 1] = { ...run, end: starts.length };
      }
      body = owner;
    }
    this.starts = Uint32Array.from([...starts, triangles]);
    this.runs = runs;
  }

  get count(): number {
    return this.starts.length - 1;
  }
}

/** Of each cluster, in the coordinates of its batch. */
export const lumpsOf = (clusters: Clusters, { positions, indices }: BatchArrays): Lump[] =>
  Array.from({ length: clusters.count }, (_, k) => lumpOf(positions, corners(clusters, indices, k)));

const corners = ({ starts }: Clusters, indices: Uint32Array, k: number): Uint32Array =>
  indices.subarray(3 * starts[k], 3 * starts[k + 1]);

/** A ball round the middle of the box. */
function lumpOf(p: Float32Array, indices: Uint32Array): Lump {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const v of indices)
    for (let k = 0; k < 3; k++) {
      const x = p[3 * v + k];
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
  const [x, y, z] = low.map((l, k) => (l + high[k]) / 2);
  let [square, longest] = [0, 0];
  for (let i = 0; i < indices.length; i++) {
    const [a, b] = [3 * indices[i], 3 * indices[i % 3 === 2 ? i - 2 : i + 1]];
    square = Math.max(square, (p[a] - x) ** 2 + (p[a + 1] - y) ** 2 + (p[a + 2] - z) ** 2);
    longest = Math.max(longest, (p[a] - p[b]) ** 2 + (p[a + 1] - p[b + 1]) ** 2 + (p[a + 2] - p[b + 2]) ** 2);
  }
  return { x, y, z, radius: Math.sqrt(square), longest: Math.sqrt(longest), speed: 0 };
}

/** What holds all lumps of one body. */
export function together(lumps: readonly Lump[]): Lump {
  if (lumps.length === 1) return lumps[0];
  const middle = (get: (l: Lump) => number) =>
    (Math.min(...lumps.map((l) => get(l) - l.radius)) + Math.max(...lumps.map((l) => get(l) + l.radius))) / 2;
  const [x, y, z] = [middle((l) => l.x), middle((l) => l.y), middle((l) => l.z)];
  const most = (get: (l: Lump) => number) => lumps.reduce((m, l) => Math.max(m, get(l)), 0);
  return {
    x,
    y,
    z,
    radius: most((l) => l.radius + Math.hypot(l.x - x, l.y - y, l.z - z)),
    longest: most((l) => l.longest),
    speed: most((l) => l.speed),
  };
}

/** The clusters of a deforming mesh, measured from the motion's origin; each sample is worked out when it is first needed. */
export class DeformingLumps {
  private readonly clusters: Clusters;
  private readonly indices: Uint32Array;
  private readonly motion: SampledPointsMotion;
  private readonly atSample = new Map<number, readonly Lump[]>();
  /** From sample k to the next, per cluster [m/s]. */
  private readonly speeds = new Map<number, Float64Array>();
  private last: { readonly window: Window; readonly lumps: readonly Lump[] } | undefined;

  constructor(clusters: Clusters, indices: Uint32Array, motion: SampledPointsMotion) {
    this.clusters = clusters;
    this.indices = indices;
    this.motion = motion;
  }

  /** What holds each cluster at all samples of a window, and so between them. */
  over(window: Window): readonly Lump[] {
    if (this.last?.window.first === window.first && this.last.window.count === window.count) return this.last.lumps;
    const samples = Array.from({ length: window.count }, (_, i) => this.lumpsAt(window.first + i));
    const speeds = Array.from({ length: window.count - 1 }, (_, i) => this.speedsFrom(window.first + i));
    const lumps = samples[0].map((_, k) => ({
      ...together(samples.map((s) => s[k])),
      speed: speeds.reduce((most, s) => Math.max(most, s[k]), 0),
    }));
    this.last = { window, lumps };
    return lumps;
  }

  private lumpsAt(sample: number): readonly Lump[] {
    const { clusters, indices, motion } = this;
    const known = this.atSample.get(sample);
    const lumps =
      known ??
      Array.from({ length: clusters.count }, (_, k) => lumpOf(motion.points[sample], corners(clusters, indices, k)));
    this.atSample.set(sample, lumps);
    return lumps;
  }

  private speedsFrom(sample: number): Float64Array {
    const { clusters, indices, motion } = this;
    const known = this.speeds.get(sample);
    if (known) return known;
    const [p, q] = [motion.points[sample], motion.points[sample + 1]];
    const dt = motion.times[sample + 1] - motion.times[sample];
    const speeds = new Float64Array(clusters.count);
    for (let k = 0; k < clusters.count; k++)
      for (const v of corners(clusters, indices, k)) {
        const moved = Math.hypot(q[3 * v] - p[3 * v], q[3 * v + 1] - p[3 * v + 1], q[3 * v + 2] - p[3 * v + 2]);
        speeds[k] = Math.max(speeds[k], moved / dt);
      }
    this.speeds.set(sample, speeds);
    return speeds;
  }
}
