import type { ClusterBounds } from '../criterion/projectedBody.ts';
import type { PlannedBatch } from '../projection/projectBody.ts';

/** Most triangles of a cluster. */
const MAX_CLUSTER_TRIANGLES = 128;

/** All clusters of one body in a batch: [first, end). */
export interface ClusterRange {
  /** Object id − 1. */
  readonly body: number;
  /** Of a mesh that many wear, the body's place among them. */
  readonly instance: number;
  /** Cluster of the arrays that is the first; those of a mesh that many wear are every body's. */
  readonly firstInMesh: number;
  readonly first: number;
  readonly end: number;
}

/** A batch's triangles in runs of neighbours in the index buffer, each of one body; of a mesh that many wear, each body has all of them. */
export class Clusters {
  /** First triangle of each cluster, and after the last one the number of triangles. */
  readonly starts: Uint32Array;
  readonly ranges: readonly ClusterRange[];

  constructor({ arrays, bodies, instancing: worn }: Pick<PlannedBatch, 'arrays' | 'bodies' | 'instancing'>) {
    if (worn) {
      const triangles = arrays.indices.length / 3;
      const each = Math.ceil(triangles / MAX_CLUSTER_TRIANGLES);
      this.starts = Uint32Array.from({ length: each + 1 }, (_, k) => Math.min(triangles, MAX_CLUSTER_TRIANGLES * k));
      this.ranges = bodies.map(({ id }, i) => ({
        body: id - 1,
        instance: i,
        firstInMesh: 0,
        first: i * each,
        end: (i + 1) * each,
      }));
      return;
    }
    const { indices, ids } = arrays;
    const triangles = indices.length / 3;
    const starts: number[] = [];
    const runs: ClusterRange[] = [];
    let body = -1;
    for (let t = 0; t < triangles; t++) {
      const owner = ids[2 * indices[3 * t]];
      if (owner !== body)
        runs.push({ body: owner, instance: 0, firstInMesh: starts.length, first: starts.length, end: starts.length });
      if (owner !== body || t - starts[starts.length - 1] >= MAX_CLUSTER_TRIANGLES) {
        starts.push(t);
        const run = runs[runs.length - 1];
        runs[runs.length - 1] = { ...run, end: starts.length };
      }
      body = owner;
    }
    this.starts = Uint32Array.from([...starts, triangles]);
    this.ranges = runs;
  }

  /** In the arrays. */
  get count(): number {
    return this.starts.length - 1;
  }

  /** Of all bodies: what has a fate of its own. */
  get totalCount(): number {
    return this.ranges.reduce((most, { end }) => Math.max(most, end), 0);
  }
}

/** Of each cluster, in the coordinates of its batch. */
export function clusterBoundsOf(clusters: Clusters, { positions, indices }: PlannedBatch['arrays']): ClusterBounds[] {
  const ball = new Float64Array(4);
  return Array.from({ length: clusters.count }, (_, k) => {
    const corners = clusterIndices(clusters, indices, k);
    clusterSphere(positions, corners, ball, 0);
    return {
      x: ball[0],
      y: ball[1],
      z: ball[2],
      radius: ball[3],
      longestEdge: longestEdge(positions, corners),
      maxSpeed: 0,
    };
  });
}

export const clusterIndices = ({ starts }: Clusters, indices: Uint32Array, k: number): Uint32Array =>
  indices.subarray(3 * starts[k], 3 * starts[k + 1]);

/** A ball round the middle of the box of some vertices: (middle, radius) at out[at …]. */
export function clusterSphere(p: Float32Array, vertices: Uint32Array, out: Float64Array, at: number): void {
  for (let k = 0; k < 3; k++) {
    let [low, high] = [Infinity, -Infinity];
    for (const v of vertices) {
      const x = p[3 * v + k];
      if (x < low) low = x;
      if (x > high) high = x;
    }
    out[at + k] = (low + high) / 2;
  }
  const [x, y, z] = [out[at], out[at + 1], out[at + 2]];
  let square = 0;
  for (const v of vertices) {
    const [dx, dy, dz] = [p[3 * v] - x, p[3 * v + 1] - y, p[3 * v + 2] - z];
    const d = dx * dx + dy * dy + dz * dz;
    if (d > square) square = d;
  }
  out[at + 3] = Math.sqrt(square);
}

/** Of triangles, whose corners these are. */
export function longestEdge(p: Float32Array, corners: Uint32Array): number {
  let square = 0;
  for (let i = 0; i < corners.length; i++) {
    const [a, b] = [3 * corners[i], 3 * corners[i % 3 === 2 ? i - 2 : i + 1]];
    const [dx, dy, dz] = [p[a] - p[b], p[a + 1] - p[b + 1], p[a + 2] - p[b + 2]];
    const d = dx * dx + dy * dy + dz * dz;
    if (d > square) square = d;
  }
  return Math.sqrt(square);
}

/** What holds all lumps of one body. */
export function mergeBounds(lumps: readonly ClusterBounds[]): ClusterBounds {
  if (lumps.length === 1) return lumps[0];
  const middle = (get: (l: ClusterBounds) => number) =>
    (Math.min(...lumps.map((l) => get(l) - l.radius)) + Math.max(...lumps.map((l) => get(l) + l.radius))) / 2;
  const [x, y, z] = [middle((l) => l.x), middle((l) => l.y), middle((l) => l.z)];
  const most = (get: (l: ClusterBounds) => number) => lumps.reduce((m, l) => Math.max(m, get(l)), 0);
  return {
    x,
    y,
    z,
    radius: most((l) => l.radius + Math.hypot(l.x - x, l.y - y, l.z - z)),
    longestEdge: most((l) => l.longestEdge),
    maxSpeed: most((l) => l.maxSpeed),
  };
}
