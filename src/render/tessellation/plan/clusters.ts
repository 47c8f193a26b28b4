import { type BatchSolid, TrianglePoints } from '../../geometry/batchSolids.ts';
import type { ClusterBounds } from '../criterion/projectedBody.ts';
import type { PlannedBatch } from '../projection/projectBody.ts';

/** Most triangles of a cluster. */
const MAX_CLUSTER_TRIANGLES = 128;
const BULGE_MARGIN = 1.25;

/** The clusters of one body in a batch: [first, end) among the clusters of all bodies. */
export interface ClusterRange {
  /** Object id − 1. */
  readonly body: number;
  /** With instancing, the index of the body among the bodies of the batch; otherwise 0. */
  readonly instance: number;
  /** Index of the first cluster in the mesh; 0 with instancing, because all bodies share the clusters of the mesh. */
  readonly firstInMesh: number;
  readonly first: number;
  readonly end: number;
}

/** Divides a batch's triangles into runs that are contiguous in the index buffer and belong to one body; with instancing, every body has all of them. */
export class Clusters {
  /** First triangle of each cluster, and after the last one the number of triangles. */
  readonly starts: Uint32Array;
  readonly ranges: readonly ClusterRange[];

  constructor({ arrays, bodies, instancing }: Pick<PlannedBatch, 'arrays' | 'bodies' | 'instancing'>) {
    if (instancing) {
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
    const ranges: ClusterRange[] = [];
    let body = -1;
    for (let t = 0; t < triangles; t++) {
      const owner = ids[2 * indices[3 * t]];
      if (owner !== body)
        ranges.push({ body: owner, instance: 0, firstInMesh: starts.length, first: starts.length, end: starts.length });
      if (owner !== body || t - starts[starts.length - 1] >= MAX_CLUSTER_TRIANGLES) {
        starts.push(t);
        const range = ranges[ranges.length - 1];
        ranges[ranges.length - 1] = { ...range, end: starts.length };
      }
      body = owner;
    }
    this.starts = Uint32Array.from([...starts, triangles]);
    this.ranges = ranges;
  }

  /** Number of clusters of the mesh. */
  get count(): number {
    return this.starts.length - 1;
  }

  /** Number of clusters of all bodies, each of which has a state of its own. */
  get totalCount(): number {
    return this.ranges.reduce((most, { end }) => Math.max(most, end), 0);
  }
}

/** The bounds of each cluster, in the coordinates of its batch. */
export function clusterBoundsOf(
  clusters: Clusters,
  { arrays, bodies, instancing, solids }: PlannedBatch,
): ClusterBounds[] {
  const { positions, indices, ids } = arrays;
  const sphere = new Float64Array(4);
  return Array.from({ length: clusters.count }, (_, k) => {
    const corners = clusterIndices(clusters, indices, k);
    clusterSphere(positions, corners, sphere, 0);
    const solid = solids?.get(instancing ? bodies[0].id : ids[2 * corners[0]] + 1);
    const bulge = solid ? largestBulge(positions, solid, corners) : 0;
    return {
      x: sphere[0],
      y: sphere[1],
      z: sphere[2],
      radius: sphere[3] + bulge,
      ...(bulge > 0 && { bulge }),
      longestEdge: longestEdge(positions, corners),
      maxSpeed: 0,
    };
  });
}

/** Of triangles of a round solid, with a margin for what is between the places where it is measured. */
function largestBulge(positions: Float32Array, solid: BatchSolid, corners: Uint32Array): number {
  const points = new TrianglePoints(positions, solid);
  let largest = 0;
  for (let i = 0; i + 2 < corners.length; i += 3) {
    points.select(corners[i], corners[i + 1], corners[i + 2]);
    largest = Math.max(largest, points.bulge());
  }
  return BULGE_MARGIN * largest;
}

export const clusterIndices = ({ starts }: Clusters, indices: Uint32Array, k: number): Uint32Array =>
  indices.subarray(3 * starts[k], 3 * starts[k + 1]);

/** Writes a bounding sphere of some vertices, around the centre of their box: (centre, radius) at out[at …]. */
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

/** The longest edge of the triangles whose corners these are. */
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

/** Bounds of all these clusters of one body. */
export function mergeBounds(clusters: readonly ClusterBounds[]): ClusterBounds {
  if (clusters.length === 1) return clusters[0];
  const middle = (get: (c: ClusterBounds) => number) =>
    (Math.min(...clusters.map((c) => get(c) - c.radius)) + Math.max(...clusters.map((c) => get(c) + c.radius))) / 2;
  const [x, y, z] = [middle((c) => c.x), middle((c) => c.y), middle((c) => c.z)];
  const largest = (get: (c: ClusterBounds) => number) => clusters.reduce((m, c) => Math.max(m, get(c)), 0);
  return {
    x,
    y,
    z,
    radius: largest((c) => c.radius + Math.hypot(c.x - x, c.y - y, c.z - z)),
    longestEdge: largest((c) => c.longestEdge),
    bulge: largest((c) => c.bulge ?? 0),
    maxSpeed: largest((c) => c.maxSpeed),
  };
}
