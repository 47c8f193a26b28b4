import { type CubicPointsMotion, innerControlPoints, isCubic } from '../../../scene/motion/cubicPoints.ts';
import { pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../../../scene/types.ts';
import type { ClusterBounds } from '../criterion/projectedBody.ts';
import type { SampleWindow } from '../projection/sampledIntersector.ts';
import { type Clusters, clusterIndices, clusterSphere, longestEdge, mergeBounds } from './clusters.ts';

/** Samples that are known are kept, up to so many times those of the widest picture. */
const MAX_CACHED = 4;

/** Numbers of a cluster at a sample: the middle and the radius of a ball that holds it, and its longest edge [m]. */
const SPHERE_FLOATS = 5;

/**
 * How the vertices of each cluster move at a sample [m/s]: at most, in the piece that ends there, and how much that changes there; and how fast it
 * changes within that piece at most [m/s²].
 */
interface VelocityBounds {
  readonly speeds: Float64Array;
  readonly jumps: Float64Array;
  readonly rates: Float64Array;
}

/** The clusters of a deforming mesh, measured from the motion's origin; each sample is worked out when it is first needed. */
export class DeformingClusterBounds {
  private readonly clusters: readonly Cluster[];
  private readonly motion: SampledPointsMotion;
  private readonly spheres = new Map<number, Float64Array>();
  private readonly controlSpheres = new Map<number, readonly Float64Array[]>();
  private readonly velocityBounds = new Map<number, VelocityBounds>();
  private widest = 0;
  private last: { readonly window: SampleWindow; readonly lumps: readonly ClusterBounds[] } | undefined;

  constructor(clusters: Clusters, indices: Uint32Array, motion: SampledPointsMotion) {
    this.clusters = Array.from({ length: clusters.count }, (_, k) => clusterOf(clusterIndices(clusters, indices, k)));
    this.motion = motion;
  }

  /** What holds each cluster at all samples of a window, and so between them. */
  boundsOver(window: SampleWindow): readonly ClusterBounds[] {
    if (this.last?.window.first === window.first && this.last.window.count === window.count) return this.last.lumps;
    const { motion } = this;
    const samples = Array.from({ length: window.count }, (_, i) => window.first + i);
    const places = samples.map((k) => cached(this.spheres, k, () => this.spheresOf(pointsAt(motion, k))));
    if (isCubic(motion))
      for (const k of samples.slice(1))
        places.push(...cached(this.controlSpheres, k, () => this.controlSpheresBefore(motion, k)));
    const paces = samples.map((k) => cached(this.velocityBounds, k, () => this.velocityBoundsAt(k)));
    const lumps = this.clusters.map((_, i) => ({
      ...mergeBounds(places.map((place) => boundsAt(place, SPHERE_FLOATS * i))),
      maxSpeed: maxOver(paces, ({ speeds }) => speeds[i]),
      maxAcceleration: maxOver(paces, ({ rates }) => rates[i] ?? 0),
      velocityJumps: Float64Array.from(paces, ({ jumps }) => jumps[i]),
    }));
    this.last = { window, lumps };
    this.evictOutside(window);
    return lumps;
  }

  private spheresOf(points: Float32Array): Float64Array {
    const places = new Float64Array(SPHERE_FLOATS * this.clusters.length);
    this.clusters.forEach(({ vertices, corners }, i) => {
      clusterSphere(points, vertices, places, SPHERE_FLOATS * i);
      places[SPHERE_FLOATS * i + 4] = longestEdge(points, corners);
    });
    return places;
  }

  /** Of the inner control points of the piece that ends with a sample. */
  private controlSpheresBefore(motion: CubicPointsMotion, sample: number): readonly Float64Array[] {
    return innerControlPoints(motion, sample - 1).map((points) => this.spheresOf(points));
  }

  private velocityBoundsAt(sample: number): VelocityBounds {
    const { clusters, motion } = this;
    if (isCubic(motion)) return cubicVelocityBounds(motion, sample, clusters);
    const [before, after] = [velocities(motion, sample), velocities(motion, sample + 1)];
    const jolts = maxPerCluster(clusters, difference(after, before));
    return { speeds: maxPerCluster(clusters, before), jumps: jolts, rates: NONE };
  }

  /** A long motion has more samples than there is memory for what is known of them. */
  private evictOutside({ first, count }: SampleWindow): void {
    this.widest = Math.max(this.widest, count);
    for (const known of [this.spheres, this.controlSpheres, this.velocityBounds])
      if (known.size > MAX_CACHED * this.widest)
        for (const k of known.keys()) if (k < first || k >= first + count) known.delete(k);
  }
}

/** The corners of a cluster's triangles, and its vertices, each once. */
interface Cluster {
  readonly corners: Uint32Array;
  readonly vertices: Uint32Array;
}

const clusterOf = (corners: Uint32Array): Cluster => ({ corners, vertices: Uint32Array.from(new Set(corners)) });

const boundsAt = (places: Float64Array, at: number): ClusterBounds => ({
  x: places[at],
  y: places[at + 1],
  z: places[at + 2],
  radius: places[at + 3],
  longestEdge: places[at + 4],
  maxSpeed: 0,
});

/** Of the pieces between the samples of a window: its first one ends a piece before it. */
const maxOver = (paces: readonly VelocityBounds[], of: (pace: VelocityBounds) => number): number =>
  paces.slice(1).reduce((greatest, pace) => Math.max(greatest, of(pace)), 0);

const NONE = new Float64Array(0);

/** Of each cluster, the greatest length of a vertex's vector. */
function maxPerCluster(clusters: readonly Cluster[], vectors: Float64Array): Float64Array {
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
function cubicVelocityBounds(
  { times, points, velocities }: CubicPointsMotion,
  sample: number,
  clusters: readonly Cluster[],
): VelocityBounds {
  const v = Float64Array.from(velocities[sample]);
  const finish = maxPerCluster(clusters, v);
  const end = sample === 0 || sample === times.length - 1;
  const jolts = end ? finish : new Float64Array(finish.length);
  if (sample === 0) return { speeds: jolts, jumps: jolts, rates: NONE };
  const [a, b, u] = [points[sample - 1], points[sample], Float64Array.from(velocities[sample - 1])];
  const span = times[sample] - times[sample - 1];
  const inner = u.map((u, i) => (3 * (b[i] - a[i])) / span - u - v[i]);
  const speeds = elementwiseMax(elementwiseMax(maxPerCluster(clusters, u), maxPerCluster(clusters, inner)), finish);
  const bends = elementwiseMax(
    maxPerCluster(clusters, difference(inner, u)),
    maxPerCluster(clusters, difference(v, inner)),
  );
  return { jumps: jolts, speeds, rates: bends.map((bend) => (2 / span) * bend) };
}

const elementwiseMax = (a: Float64Array, b: Float64Array): Float64Array => a.map((x, i) => Math.max(x, b[i]));

function cached<T>(known: Map<number, T>, key: number, make: () => T): T {
  const value = known.get(key) ?? make();
  known.set(key, value);
  return value;
}
