import type { PlannedBatch } from './showing.ts';
import type { Lump } from './shown.ts';

/** Most triangles of a cluster. */
const CLUSTER = 128;

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
export function lumpsOf(clusters: Clusters, { positions, indices }: PlannedBatch['arrays']): Lump[] {
  const ball = new Float64Array(4);
  return Array.from({ length: clusters.count }, (_, k) => {
    const corners = cornersOf(clusters, indices, k);
    ballAround(positions, corners, ball, 0);
    return { x: ball[0], y: ball[1], z: ball[2], radius: ball[3], longest: longestEdge(positions, corners), speed: 0 };
  });
}

export const cornersOf = ({ starts }: Clusters, indices: Uint32Array, k: number): Uint32Array =>
  indices.subarray(3 * starts[k], 3 * starts[k + 1]);

/** A ball round the middle of the box of some vertices: (middle, radius) at out[at …]. */
export function ballAround(p: Float32Array, vertices: Uint32Array, out: Float64Array, at: number): void {
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
