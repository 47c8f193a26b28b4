import type { Mesh, MeshGroup, SceneObject } from './types.ts';

export interface Subdivision<T> {
  readonly result: T;
  /** The budget ended the work before every edge was short enough. */
  readonly stoppedByBudget: boolean;
  /** Longest edge left [m]. */
  readonly longestEdge: number;
}

/**
 * Splits edges longer than `maxEdge` [m] at their middle until none is left. Straight edges seen at speed are curves,
 * so a long one must be cut before its vertices are transformed (docs/model.md).
 *
 * Crack-free: whether an edge is split depends on its own two ends alone, so triangles that share it always agree,
 * also across uv seams, groups and meshes. The longest edges go first; the pass that would exceed `budget` triangles is
 * not begun, so what is left is whole and as even as the budget allows. Attributes are interpolated, normals kept unit.
 */
export function subdivideLongEdges(mesh: Mesh, maxEdge: number, budget: number): Subdivision<Mesh> {
  const work = new Subdivider(mesh, [mesh.positions], []);
  const end = work.run(maxEdge, budget);
  return { ...end, result: work.mesh(mesh, work.places[0]) };
}

/** As `subdivideLongEdges`; a deforming object's edges are as long as they ever get, and all its samples follow. */
export function subdivideObject(object: SceneObject, maxEdge: number, budget: number): Subdivision<SceneObject> {
  const { mesh, motion } = object;
  if (motion.kind !== 'sampled-points') {
    const { result, ...end } = subdivideLongEdges(mesh, maxEdge, budget);
    return { ...end, result: { ...object, mesh: result } };
  }
  const work = new Subdivider(mesh, [mesh.positions, ...motion.points], motion.normals ?? []);
  const end = work.run(maxEdge, budget);
  const points = work.places.slice(1);
  const normals = motion.normals ? { normals: work.directions.slice(1) } : {};
  const result = { ...object, mesh: work.mesh(mesh, work.places[0]), motion: { ...motion, points, ...normals } };
  return { ...end, result };
}

class Subdivider {
  /** Positions at rest and at each sample; an edge is as long as in the sample where it is longest. */
  places: Float32Array[];
  /** Unit normals at rest and at each sample. */
  directions: Float32Array[];
  private uvs: Float32Array;
  private colors: Float32Array | undefined;
  private indices: Uint32Array;
  private groups: readonly MeshGroup[];

  constructor(mesh: Mesh, places: readonly Float32Array[], sampleNormals: readonly Float32Array[]) {
    this.places = [...places];
    this.directions = [mesh.normals, ...sampleNormals];
    this.uvs = mesh.uvs;
    this.colors = mesh.colors;
    this.indices = mesh.indices;
    this.groups = mesh.groups;
  }

  run(maxEdge: number, budget: number): Omit<Subdivision<Mesh>, 'result'> {
    let longest = this.longestEdge();
    let threshold = maxEdge * 2 ** Math.max(0, Math.ceil(Math.log2(longest / maxEdge)) - 1);
    while (longest > maxEdge && Number.isFinite(longest)) {
      while (threshold > maxEdge && longest <= threshold) threshold /= 2;
      const split = this.longEdges(threshold);
      if (this.trianglesAfter(split) > budget) return { stoppedByBudget: true, longestEdge: longest };
      this.split(split);
      longest = this.longestEdge();
    }
    return { stoppedByBudget: false, longestEdge: longest };
  }

  mesh(from: Mesh, positions: Float32Array): Mesh {
    return {
      positions,
      normals: this.directions[0],
      uvs: this.uvs,
      ...(this.colors ? { colors: this.colors } : {}),
      indices: this.indices,
      groups: this.groups,
      doubleSided: from.doubleSided,
    };
  }

  private edgeLength(a: number, b: number): number {
    let longest = 0;
    for (const p of this.places) {
      const x = p[3 * a] - p[3 * b];
      const y = p[3 * a + 1] - p[3 * b + 1];
      const z = p[3 * a + 2] - p[3 * b + 2];
      longest = Math.max(longest, x * x + y * y + z * z);
    }
    return Math.sqrt(longest);
  }

  private longestEdge(): number {
    let longest = 0;
    this.forEachEdge((a, b) => {
      longest = Math.max(longest, this.edgeLength(a, b));
    });
    return longest;
  }

  private forEachEdge(visit: (a: number, b: number) => void): void {
    const t = this.indices;
    for (let i = 0; i + 2 < t.length; i += 3) {
      visit(t[i], t[i + 1]);
      visit(t[i + 1], t[i + 2]);
      visit(t[i + 2], t[i]);
    }
  }

  /** Edge → number of its middle vertex, in order of first meeting. */
  private longEdges(threshold: number): Map<number, number> {
    const split = new Map<number, number>();
    this.forEachEdge((a, b) => {
      if (this.edgeLength(a, b) <= threshold) return;
      const key = this.edgeKey(a, b);
      if (!split.has(key)) split.set(key, this.vertexCount() + split.size);
    });
    return split;
  }

  private vertexCount(): number {
    return this.places[0].length / 3;
  }

  private edgeKey(a: number, b: number): number {
    return Math.min(a, b) * this.vertexCount() + Math.max(a, b);
  }

  private trianglesAfter(split: ReadonlyMap<number, number>): number {
    let count = this.indices.length / 3;
    this.forEachEdge((a, b) => {
      if (split.has(this.edgeKey(a, b))) count++;
    });
    return count;
  }

  private split(split: ReadonlyMap<number, number>): void {
    const indices: number[] = [];
    const groups: MeshGroup[] = [];
    const middles = this.middlePlaces(split);
    for (const g of this.groups) {
      const start = indices.length;
      for (let i = g.start; i + 2 < g.start + g.count; i += 3) this.splitTriangle(i, split, middles, indices);
      groups.push({ ...g, start, count: indices.length - start });
    }
    this.extend(split);
    this.indices = Uint32Array.from(indices);
    this.groups = groups;
  }

  /** Rest positions with the middles appended: needed before `extend` to choose diagonals. */
  private middlePlaces(split: ReadonlyMap<number, number>): Float32Array {
    return extended(this.places[0], 3, split, this.vertexCount());
  }

  private splitTriangle(i: number, split: ReadonlyMap<number, number>, places: Float32Array, out: number[]): void {
    const v = [this.indices[i], this.indices[i + 1], this.indices[i + 2]] as const;
    const m = [0, 1, 2].map((k) => split.get(this.edgeKey(v[k], v[(k + 1) % 3])) ?? WHOLE);
    const count = m.filter((x) => x !== WHOLE).length;
    if (count === 0) out.push(...v);
    else if (count === 3) out.push(v[0], m[0], m[2], m[0], v[1], m[1], m[2], m[1], v[2], m[0], m[1], m[2]);
    else if (count === 1) splitOnce(v, m, out);
    else splitTwice(v, m, places, out);
  }

  private extend(split: ReadonlyMap<number, number>): void {
    const n = this.vertexCount();
    this.directions = this.directions.map((d) => normalizedFrom(extended(d, 3, split, n), n));
    this.uvs = extended(this.uvs, 2, split, n);
    if (this.colors) this.colors = extended(this.colors, 3, split, n);
    this.places = this.places.map((p) => extended(p, 3, split, n));
  }
}

type Corners = readonly [number, number, number];
/** The middle vertex of each edge, or WHOLE. */
type Middles = readonly number[];
const WHOLE = -1;

function splitOnce(v: Corners, m: Middles, out: number[]): void {
  const k = m.findIndex((x) => x !== WHOLE);
  const [a, b, c] = [v[k], v[(k + 1) % 3], v[(k + 2) % 3]];
  out.push(a, m[k], c, m[k], b, c);
}

/** Cuts off the corner between the two split edges; the quad left is cut along its shorter diagonal. */
function splitTwice(v: Corners, m: Middles, places: Float32Array, out: number[]): void {
  const whole = m.indexOf(WHOLE);
  const [a, b, c] = [v[whole], v[(whole + 1) % 3], v[(whole + 2) % 3]];
  const bc = m[(whole + 1) % 3];
  const ca = m[(whole + 2) % 3];
  out.push(bc, c, ca);
  if (squaredDistance(places, a, bc) <= squaredDistance(places, b, ca)) out.push(a, b, bc, a, bc, ca);
  else out.push(a, b, ca, b, bc, ca);
}

function squaredDistance(p: Float32Array, a: number, b: number): number {
  let sum = 0;
  for (let k = 0; k < 3; k++) sum += (p[3 * a + k] - p[3 * b + k]) ** 2;
  return sum;
}

/** `data` with the mean of each split edge's ends appended. */
function extended(data: Float32Array, size: number, split: ReadonlyMap<number, number>, n: number): Float32Array {
  const out = new Float32Array((n + split.size) * size);
  out.set(data);
  for (const [key, middle] of split) {
    const a = Math.floor(key / n) * size;
    const b = (key % n) * size;
    for (let k = 0; k < size; k++) out[middle * size + k] = (data[a + k] + data[b + k]) / 2;
  }
  return out;
}

function normalizedFrom(normals: Float32Array, first: number): Float32Array {
  for (let i = 3 * first; i < normals.length; i += 3) {
    const l = Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
    if (l > 0) for (let k = 0; k < 3; k++) normals[i + k] = normals[i + k] / l;
  }
  return normals;
}
