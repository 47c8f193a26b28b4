import { type CubicPointsMotion, innerControls, isCubic } from '../../scene/cubicPoints.ts';
import { pointsAt } from '../../scene/points.ts';
import type { SampledPointsMotion } from '../../scene/types.ts';
import { ballAround, type Clusters, cornersOf, longestEdge, together } from './clusters.ts';
import type { Window } from './polyline.ts';
import type { Lump } from './shown.ts';

/** Samples that are known are kept, up to so many times those of the widest picture. */
const MOST_KEPT = 4;

/** Numbers of a cluster at a sample: the middle and the radius of a ball that holds it, and its longest edge [m]. */
const PLACE = 5;

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
  private readonly clusters: readonly Cluster[];
  private readonly motion: SampledPointsMotion;
  private readonly places = new Map<number, Float64Array>();
  private readonly bulges = new Map<number, readonly Float64Array[]>();
  private readonly paces = new Map<number, Pace>();
  private widest = 0;
  private last: { readonly window: Window; readonly lumps: readonly Lump[] } | undefined;

  constructor(clusters: Clusters, indices: Uint32Array, motion: SampledPointsMotion) {
    this.clusters = Array.from({ length: clusters.count }, (_, k) => clusterOf(cornersOf(clusters, indices, k)));
    this.motion = motion;
  }

  /** What holds each cluster at all samples of a window, and so between them. */
  over(window: Window): readonly Lump[] {
    if (this.last?.window.first === window.first && this.last.window.count === window.count) return this.last.lumps;
    const { motion } = this;
    const samples = Array.from({ length: window.count }, (_, i) => window.first + i);
    const places = samples.map((k) => kept(this.places, k, () => this.placesOf(pointsAt(motion, k))));
    if (isCubic(motion))
      for (const k of samples.slice(1)) places.push(...kept(this.bulges, k, () => this.bulgesBefore(motion, k)));
    const paces = samples.map((k) => kept(this.paces, k, () => this.paceAt(k)));
    const lumps = this.clusters.map((_, i) => ({
      ...together(places.map((place) => lumpAt(place, PLACE * i))),
      speed: most(paces, ({ speeds }) => speeds[i]),
      rate: most(paces, ({ rates }) => rates[i] ?? 0),
      jolts: Float64Array.from(paces, ({ jolts }) => jolts[i]),
    }));
    this.last = { window, lumps };
    this.forgetOutside(window);
    return lumps;
  }

  private placesOf(points: Float32Array): Float64Array {
    const places = new Float64Array(PLACE * this.clusters.length);
    this.clusters.forEach(({ vertices, corners }, i) => {
      ballAround(points, vertices, places, PLACE * i);
      places[PLACE * i + 4] = longestEdge(points, corners);
    });
    return places;
  }

  /** Of the inner control points of the piece that ends with a sample. */
  private bulgesBefore(motion: CubicPointsMotion, sample: number): readonly Float64Array[] {
    return innerControls(motion, sample - 1).map((points) => this.placesOf(points));
  }

  private paceAt(sample: number): Pace {
    const { clusters, motion } = this;
    if (isCubic(motion)) return cubicPace(motion, sample, clusters);
    const [before, after] = [velocities(motion, sample), velocities(motion, sample + 1)];
    const jolts = greatest(clusters, difference(after, before));
    return { speeds: greatest(clusters, before), jolts, rates: NONE };
  }

  /** A long motion has more samples than there is memory for what is known of them. */
  private forgetOutside({ first, count }: Window): void {
    this.widest = Math.max(this.widest, count);
    for (const known of [this.places, this.bulges, this.paces])
      if (known.size > MOST_KEPT * this.widest)
        for (const k of known.keys()) if (k < first || k >= first + count) known.delete(k);
  }
}

/** The corners of a cluster's triangles, and its vertices, each once. */
interface Cluster {
  readonly corners: Uint32Array;
  readonly vertices: Uint32Array;
}

const clusterOf = (corners: Uint32Array): Cluster => ({ corners, vertices: Uint32Array.from(new Set(corners)) });

const lumpAt = (places: Float64Array, at: number): Lump => ({
  x: places[at],
  y: places[at + 1],
  z: places[at + 2],
  radius: places[at + 3],
  longest: places[at + 4],
  speed: 0,
});

/** Of the pieces between the samples of a window: its first one ends a piece before it. */
const most = (paces: readonly Pace[], of: (pace: Pace) => number): number =>
  paces.slice(1).reduce((greatest, pace) => Math.max(greatest, of(pace)), 0);

const NONE = new Float64Array(0);

/** Of each cluster, the greatest length of a vertex's vector. */
function greatest(clusters: readonly Cluster[], vectors: Float64Array): Float64Array {
  const squares = new Float64Array(vectors.length / 3);
  for (let v = 0; v < squares.length; v++)
    squares[v] = vectors[3 * v] ** 2 + vectors[3 * v + 1] ** 2 + vectors[3 * v + 2] ** 2;
  return Float64Array.from(clusters, ({ vertices }) => {
    let most = 0;
    for (const v of vertices) if (squares[v] > most) most = squares[v];
    return Math.sqrt(most);
  });
}

/** Of the vertices, in the piece that ends with a sample [m/s]; outside the samples they rest. */
function velocities(motion: SampledPointsMotion, sample: number): Float64Array {
  const { times } = motion;
  const q = pointsAt(motion, Math.min(sample, times.length - 1));
  const v = new Float64Array(q.length);
  if (sample < 1 || sample >= times.length) return v;
  const [p, dt] = [pointsAt(motion, sample - 1), times[sample] - times[sample - 1]];
  for (let i = 0; i < v.length; i++) v[i] = (q[i] - p[i]) / dt;
  return v;
}

function difference(a: Float64Array, b: Float64Array): Float64Array {
  const d = new Float64Array(a.length);
  for (let i = 0; i < d.length; i++) d[i] = a[i] - b[i];
  return d;
}

/** Of cubics with all of their bend: velocities change suddenly only where the motion begins and ends. */
function cubicPace(
  { times, points, velocities }: CubicPointsMotion,
  sample: number,
  clusters: readonly Cluster[],
): Pace {
  const v = Float64Array.from(velocities[sample]);
  const finish = greatest(clusters, v);
  const end = sample === 0 || sample === times.length - 1;
  const jolts = end ? finish : new Float64Array(finish.length);
  if (sample === 0) return { speeds: jolts, jolts, rates: NONE };
  const [a, b, u] = [points[sample - 1], points[sample], Float64Array.from(velocities[sample - 1])];
  const span = times[sample] - times[sample - 1];
  const inner = u.map((u, i) => (3 * (b[i] - a[i])) / span - u - v[i]);
  const speeds = larger(larger(greatest(clusters, u), greatest(clusters, inner)), finish);
  const bends = larger(greatest(clusters, difference(inner, u)), greatest(clusters, difference(v, inner)));
  return { jolts, speeds, rates: bends.map((bend) => (2 / span) * bend) };
}

const larger = (a: Float64Array, b: Float64Array): Float64Array => a.map((x, i) => Math.max(x, b[i]));

function kept<T>(known: Map<number, T>, key: number, make: () => T): T {
  const value = known.get(key) ?? make();
  known.set(key, value);
  return value;
}
