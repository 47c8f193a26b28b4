import { type CubicPointsMotion, innerControls, isCubic } from '../../scene/cubicPoints.ts';
import { pointsAt } from '../../scene/points.ts';
import type { SampledPointsMotion } from '../../scene/types.ts';
import type { Window } from './polyline.ts';
import type { PlannedBatch } from './showing.ts';
import type { Lump } from './shown.ts';

/** Most triangles of a cluster. */
const CLUSTER = 128;

/** Samples that are known are kept, up to so many times those of a picture. */
const MOST_KEPT = 4;

/** All clusters of one body in a batch: [first, end). */
export interface Run {
  /** Object id − 1. */
  readonly body: number;
  /** Of a mesh that many wear, the body's place among them. */
  readonly wearer: number;
  /** Cluster of the arrays that is the first; those of a mesh that many wear are every body's. */
  readonly from: number;
  readonly first: number;
  readonly end: number;
}

/** A batch's triangles in runs of neighbours in the index buffer, each of one body; of a mesh that many wear, each body has all of them. */
export class Clusters {
  /** First triangle of each cluster, and after the last one the number of triangles. */
  readonly starts: Uint32Array;
  readonly runs: readonly Run[];

  constructor({ arrays, bodies, worn }: Pick<PlannedBatch, 'arrays' | 'bodies' | 'worn'>) {
    if (worn) {
      const triangles = arrays.indices.length / 3;
      const each = Math.ceil(triangles / CLUSTER);
      this.starts = Uint32Array.from({ length: each + 1 }, (_, k) => Math.min(triangles, CLUSTER * k));
      this.runs = bodies.map(({ id }, i) => ({
        body: id - 1,
        wearer: i,
        from: 0,
        first: i * each,
        end: (i + 1) * each,
      }));
      return;
    }
    const { indices, ids } = arrays;
    const triangles = indices.length / 3;
    const starts: number[] = [];
    const runs: Run[] = [];
    let body = -1;
    for (let t = 0; t < triangles; t++) {
      const owner = ids[2 * indices[3 * t]];
      if (owner !== body)
        runs.push({ body: owner, wearer: 0, from: starts.length, first: starts.length, end: starts.length });
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

  /** In the arrays. */
  get count(): number {
    return this.starts.length - 1;
  }

  /** Of all bodies: what has a fate of its own. */
  get fates(): number {
    return this.runs.reduce((most, { end }) => Math.max(most, end), 0);
  }
}

/** Of each cluster, in the coordinates of its batch. */
export const lumpsOf = (clusters: Clusters, { positions, indices }: PlannedBatch['arrays']): Lump[] =>
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

/**
 * How the vertices of each cluster move at a sample [m/s]: at most, in the piece that ends there, and how much that changes there; and how fast it
 * changes within that piece at most [m/s²].
 */
interface Pace {
  readonly speeds: Float64Array;
  readonly jolts: Float64Array;
  readonly rates: Float64Array;
}

/** The clusters of a deforming mesh, measured from the motion's origin; each sample is worked out when it is first needed. */
export class DeformingLumps {
  private readonly clusters: Clusters;
  private readonly indices: Uint32Array;
  private readonly motion: SampledPointsMotion;
  private readonly places = new Map<number, readonly Lump[]>();
  private readonly bulges = new Map<number, readonly (readonly Lump[])[]>();
  private readonly paces = new Map<number, Pace>();
  private last: { readonly window: Window; readonly lumps: readonly Lump[] } | undefined;

  constructor(clusters: Clusters, indices: Uint32Array, motion: SampledPointsMotion) {
    this.clusters = clusters;
    this.indices = indices;
    this.motion = motion;
  }

  /** What holds each cluster at all samples of a window, and so between them. */
  over(window: Window): readonly Lump[] {
    if (this.last?.window.first === window.first && this.last.window.count === window.count) return this.last.lumps;
    const { motion } = this;
    const samples = Array.from({ length: window.count }, (_, i) => window.first + i);
    const places = samples.map((k) => kept(this.places, k, () => this.placesAt(k)));
    if (isCubic(motion))
      for (const k of samples.slice(1)) places.push(...kept(this.bulges, k, () => this.bulgesBefore(motion, k)));
    const paces = samples.map((k) => kept(this.paces, k, () => this.paceAt(k)));
    const lumps = places[0].map((_, i) => ({
      ...together(places.map((lumps) => lumps[i])),
      speed: paces.slice(1).reduce((most, { speeds }) => Math.max(most, speeds[i]), 0),
      rate: paces.slice(1).reduce((most, { rates }) => Math.max(most, rates[i] ?? 0), 0),
      jolts: Float64Array.from(paces, ({ jolts }) => jolts[i]),
    }));
    this.last = { window, lumps };
    forgetOutside(this.places, window);
    forgetOutside(this.paces, window);
    return lumps;
  }

  private placesAt(sample: number): readonly Lump[] {
    return this.lumpsIn(pointsAt(this.motion, sample));
  }

  /** Of the inner control points of the piece that ends with a sample. */
  private bulgesBefore(motion: CubicPointsMotion, sample: number): readonly (readonly Lump[])[] {
    return innerControls(motion, sample - 1).map((points) => this.lumpsIn(points));
  }

  private lumpsIn(points: Float32Array): readonly Lump[] {
    const { clusters, indices } = this;
    return Array.from({ length: clusters.count }, (_, i) => lumpOf(points, corners(clusters, indices, i)));
  }

  private paceAt(sample: number): Pace {
    const { clusters, indices, motion } = this;
    const most = (of: (at: number) => number) =>
      Float64Array.from({ length: clusters.count }, (_, i) =>
        corners(clusters, indices, i).reduce((greatest, v) => Math.max(greatest, of(3 * v)), 0),
      );
    if (isCubic(motion)) return cubicPace(motion, sample, most);
    const [before, after] = [velocities(motion, sample), velocities(motion, sample + 1)];
    const jolts = most((i) =>
      Math.hypot(after(i) - before(i), after(i + 1) - before(i + 1), after(i + 2) - before(i + 2)),
    );
    return { speeds: most((i) => Math.hypot(before(i), before(i + 1), before(i + 2))), jolts, rates: NONE };
  }
}

const NONE = new Float64Array(0);

type Most = (of: (at: number) => number) => Float64Array;

/** Of cubics with all of their bend: velocities change suddenly only where the motion begins and ends. */
function cubicPace({ times, points, velocities }: CubicPointsMotion, sample: number, most: Most): Pace {
  const v = velocities[sample];
  const end = sample === 0 || sample === times.length - 1;
  const jolts = most((i) => (end ? Math.hypot(v[i], v[i + 1], v[i + 2]) : 0));
  if (sample === 0) return { speeds: jolts, jolts, rates: NONE };
  const [a, b, u] = [points[sample - 1], points[sample], velocities[sample - 1]];
  const span = times[sample] - times[sample - 1];
  const inner = (i: number) => (3 * (b[i] - a[i])) / span - u[i] - v[i];
  const norm = (of: (i: number) => number, i: number) => Math.hypot(of(i), of(i + 1), of(i + 2));
  const begin = (i: number) => u[i];
  const finish = (i: number) => v[i];
  return {
    jolts,
    speeds: most((i) => Math.max(norm(begin, i), norm(inner, i), norm(finish, i))),
    rates: most(
      (i) =>
        (2 / span) *
        Math.max(
          norm((j) => inner(j) - u[j], i),
          norm((j) => v[j] - inner(j), i),
        ),
    ),
  };
}

/** Coordinate by coordinate [m/s], in the piece that ends with a sample; outside the samples it rests. */
function velocities(motion: SampledPointsMotion, sample: number): (i: number) => number {
  const { times } = motion;
  if (sample < 1 || sample >= times.length) return () => 0;
  const [p, q, dt] = [pointsAt(motion, sample - 1), pointsAt(motion, sample), times[sample] - times[sample - 1]];
  return (i) => (q[i] - p[i]) / dt;
}

/** A long motion has more samples than there is memory for what is known of them. */
function forgetOutside(known: Map<number, unknown>, { first, count }: Window): void {
  if (known.size <= MOST_KEPT * count) return;
  for (const k of known.keys()) if (k < first || k >= first + count) known.delete(k);
}

function kept<T>(known: Map<number, T>, key: number, make: () => T): T {
  const value = known.get(key) ?? make();
  known.set(key, value);
  return value;
}
