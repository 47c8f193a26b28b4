import { type CubicPointsMotion, innerControlPoints, isCubic } from '../../../scene/motion/cubicPoints.ts';
import { pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../../../scene/types.ts';
import type { ClusterBounds } from '../criterion/projectedBody.ts';
import type { SampleWindow } from '../projection/sampledIntersector.ts';
import { type Clusters, clusterIndices, clusterSphere, longestEdge, mergeBounds } from './clusters.ts';

/** Most cached samples, as a multiple of the widest window so far. */
const MAX_CACHED = 4;

/** Floats per cluster at a sample: centre and radius of a bounding sphere, and the longest edge [m]. */
const SPHERE_FLOATS = 5;

/**
 * Bounds on the motion of each cluster's vertices: largest speed in the piece that ends at a sample [m/s], largest change of velocity at the sample [m/s],
 * and largest acceleration within the piece [m/s²].
 */
interface VelocityBounds {
  readonly speeds: Float64Array;
  readonly jumps: Float64Array;
  readonly rates: Float64Array;
}

/** Bounds of the clusters of a deforming mesh, relative to the motion's origin; samples are evaluated lazily and cached. */
export class DeformingClusterBounds {
  private readonly clusters: readonly Cluster[];
  private readonly motion: SampledPointsMotion;
  private readonly spheres = new Map<number, Float64Array>();
  private readonly controlSpheres = new Map<number, readonly Float64Array[]>();
  private readonly velocityBounds = new Map<number, VelocityBounds>();
  private widestWindow = 0;
  private last: { readonly window: SampleWindow; readonly bounds: readonly ClusterBounds[] } | undefined;

  constructor(clusters: Clusters, indices: Uint32Array, motion: SampledPointsMotion) {
    this.clusters = Array.from({ length: clusters.count }, (_, k) => clusterOf(clusterIndices(clusters, indices, k)));
    this.motion = motion;
  }

  /** Bounds of each cluster over all samples of a window, and therefore between them. */
  boundsOver(window: SampleWindow): readonly ClusterBounds[] {
    if (this.last?.window.first === window.first && this.last.window.count === window.count) return this.last.bounds;
    const { motion } = this;
    const samples = Array.from({ length: window.count }, (_, i) => window.first + i);
    const spheres = samples.map((k) => cached(this.spheres, k, () => this.spheresOf(pointsAt(motion, k))));
    if (isCubic(motion))
      for (const k of samples.slice(1))
        spheres.push(...cached(this.controlSpheres, k, () => this.controlSpheresBefore(motion, k)));
    const velocityBounds = samples.map((k) => cached(this.velocityBounds, k, () => this.velocityBoundsAt(k)));
    const bounds = this.clusters.map((_, i) => ({
      ...mergeBounds(spheres.map((sphere) => boundsAt(sphere, SPHERE_FLOATS * i))),
      maxSpeed: maxOver(velocityBounds, ({ speeds }) => speeds[i]),
      maxAcceleration: maxOver(velocityBounds, ({ rates }) => rates[i] ?? 0),
      velocityJumps: Float64Array.from(velocityBounds, ({ jumps }) => jumps[i]),
    }));
    this.last = { window, bounds };
    this.evictOutside(window);
    return bounds;
  }

  private spheresOf(points: Float32Array): Float64Array {
    const spheres = new Float64Array(SPHERE_FLOATS * this.clusters.length);
    this.clusters.forEach(({ vertices, corners }, i) => {
      clusterSphere(points, vertices, spheres, SPHERE_FLOATS * i);
      spheres[SPHERE_FLOATS * i + 4] = longestEdge(points, corners);
    });
    return spheres;
  }

  /** Spheres around the inner Bézier control points of the piece that ends at a sample. */
  private controlSpheresBefore(motion: CubicPointsMotion, sample: number): readonly Float64Array[] {
    return innerControlPoints(motion, sample - 1).map((points) => this.spheresOf(points));
  }

  private velocityBoundsAt(sample: number): VelocityBounds {
    const { clusters, motion } = this;
    if (isCubic(motion)) return cubicVelocityBounds(motion, sample, clusters);
    const [before, after] = [velocities(motion, sample), velocities(motion, sample + 1)];
    const jumps = maxPerCluster(clusters, difference(after, before));
    return { speeds: maxPerCluster(clusters, before), jumps, rates: NONE };
  }

  /** Bounds the memory of long motions: drops cached samples outside the window. */
  private evictOutside({ first, count }: SampleWindow): void {
    this.widestWindow = Math.max(this.widestWindow, count);
    for (const cache of [this.spheres, this.controlSpheres, this.velocityBounds])
      if (cache.size > MAX_CACHED * this.widestWindow)
        for (const k of cache.keys()) if (k < first || k >= first + count) cache.delete(k);
  }
}

/** The corners of a cluster's triangles, and its vertices without duplicates. */
interface Cluster {
  readonly corners: Uint32Array;
  readonly vertices: Uint32Array;
}

const clusterOf = (corners: Uint32Array): Cluster => ({ corners, vertices: Uint32Array.from(new Set(corners)) });

const boundsAt = (spheres: Float64Array, at: number): ClusterBounds => ({
  x: spheres[at],
  y: spheres[at + 1],
  z: spheres[at + 2],
  radius: spheres[at + 3],
  longestEdge: spheres[at + 4],
  maxSpeed: 0,
});

/** Maximum over the pieces between the samples of a window; the piece that ends at its first sample lies before it. */
const maxOver = (bounds: readonly VelocityBounds[], of: (bound: VelocityBounds) => number): number =>
  bounds.slice(1).reduce((max, bound) => Math.max(max, of(bound)), 0);

const NONE = new Float64Array(0);

/** The largest length of a vertex's vector in each cluster. */
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

/** Velocities of the vertices in the piece that ends at a sample [m/s]; 0 before the first and after the last sample. */
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

/** Bounds for cubics with their full bend, whose velocities jump only at the first and the last sample. */
function cubicVelocityBounds(
  { times, points, velocities }: CubicPointsMotion,
  sample: number,
  clusters: readonly Cluster[],
): VelocityBounds {
  const v = Float64Array.from(velocities[sample]);
  const endSpeeds = maxPerCluster(clusters, v);
  const isEnd = sample === 0 || sample === times.length - 1;
  const jumps = isEnd ? endSpeeds : new Float64Array(endSpeeds.length);
  if (sample === 0) return { speeds: jumps, jumps, rates: NONE };
  const [a, b, u] = [points[sample - 1], points[sample], Float64Array.from(velocities[sample - 1])];
  const span = times[sample] - times[sample - 1];
  const inner = u.map((u, i) => (3 * (b[i] - a[i])) / span - u - v[i]);
  const speeds = elementwiseMax(elementwiseMax(maxPerCluster(clusters, u), maxPerCluster(clusters, inner)), endSpeeds);
  const bends = elementwiseMax(
    maxPerCluster(clusters, difference(inner, u)),
    maxPerCluster(clusters, difference(v, inner)),
  );
  return { jumps, speeds, rates: bends.map((bend) => (2 / span) * bend) };
}

const elementwiseMax = (a: Float64Array, b: Float64Array): Float64Array => a.map((x, i) => Math.max(x, b[i]));

function cached<T>(cache: Map<number, T>, key: number, make: () => T): T {
  const value = cache.get(key) ?? make();
  cache.set(key, value);
  return value;
}
