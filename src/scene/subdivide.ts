import { type Corners, countPieces, cutTriangle } from './strips.ts';
import type { Mesh, MeshGroup, SceneObject } from './types.ts';

export interface Subdivision<T> {
  readonly result: T;
  /** The budget did not allow pieces as short as wished. */
  readonly stoppedByBudget: boolean;
  /** Longest piece of an edge of the mesh that is left [m]. */
  readonly longestEdge: number;
}

/**
 * Cuts every edge into equal pieces no longer than `maxEdge` [m], and each triangle into rows of triangles between them (whose
 * own edges are at most about √2 times as long). Straight edges seen at speed are curves, so a long one must be cut before its
 * vertices are transformed (docs/model.md).
 *
 * Crack-free: how an edge is cut depends on the places of its own two ends alone, so triangles that share it always agree,
 * also across uv seams, groups and meshes. Where the pieces would exceed `budget` triangles, all are longer alike.
 * Attributes are interpolated, normals kept unit.
 */
export function subdivideLongEdges(mesh: Mesh, maxEdge: number, budget: number): Subdivision<Mesh> {
  const edges = measureEdges(mesh, [mesh.positions]);
  const length = allowedLength(edges, maxEdge, budget);
  const end = { stoppedByBudget: length > maxEdge, longestEdge: longestPiece(edges, length) };
  if (trianglesWhenCut(edges, length) === mesh.indices.length / 3) return { ...end, result: mesh };
  const cut = new Cutter(mesh, edges, length);
  return { ...end, result: cut.mesh(mesh) };
}

/** As `subdivideLongEdges`; a deforming object's edges are as long as they ever get, and all its samples follow. */
export function subdivideObject(object: SceneObject, maxEdge: number, budget: number): Subdivision<SceneObject> {
  const { mesh, motion } = object;
  if (motion.kind !== 'sampled-points') {
    const { result, ...end } = subdivideLongEdges(mesh, maxEdge, budget);
    return { ...end, result: { ...object, mesh: result } };
  }
  const edges = objectEdges(object);
  const length = allowedLength(edges, maxEdge, budget);
  const end = { stoppedByBudget: length > maxEdge, longestEdge: longestPiece(edges, length) };
  const cut = new Cutter(mesh, edges, length);
  const points = motion.points.map((p) => cut.extended(p, 3));
  const normals = motion.normals ? { normals: motion.normals.map((n) => cut.directions(n)) } : {};
  return { ...end, result: { ...object, mesh: cut.mesh(mesh), motion: { ...motion, points, ...normals } } };
}

/** Length [m] of the edge from each corner in `indices` to the next of its triangle. */
export type EdgeLengths = Float64Array;

/** An object's edges, as long as they ever get. */
export const objectEdges = ({ mesh, motion }: SceneObject): EdgeLengths =>
  measureEdges(mesh, motion.kind === 'sampled-points' ? [mesh.positions, ...motion.points] : [mesh.positions]);

function measureEdges({ indices }: Mesh, places: readonly Float32Array[]): EdgeLengths {
  const out = new Float64Array(indices.length);
  for (let i = 0; i < indices.length; i++) {
    const a = 3 * indices[i];
    const b = 3 * indices[i % 3 === 2 ? i - 2 : i + 1];
    let square = 0;
    for (const p of places) {
      const [x, y, z] = [p[a] - p[b], p[a + 1] - p[b + 1], p[a + 2] - p[b + 2]];
      square = Math.max(square, x * x + y * y + z * z);
    }
    out[i] = Math.sqrt(square);
  }
  return out;
}

/** No edge has more pieces, whatever a file says. */
const MOST_PIECES = 1 << 16;

const piecesOf = (length: number, maxEdge: number): number =>
  length > maxEdge ? Math.min(Math.ceil(length / maxEdge), MOST_PIECES) : 1;

/** How many triangles there are when edges longer than `maxEdge` [m] are cut; an upper bound that is nearly met. */
export function trianglesWhenCut(edges: EdgeLengths, maxEdge: number): number {
  let count = 0;
  for (let i = 0; i + 2 < edges.length; i += 3) {
    const whole = edges[i] <= maxEdge && edges[i + 1] <= maxEdge && edges[i + 2] <= maxEdge;
    count += whole ? 1 : countPieces([0, 1, 2].map((k) => piecesOf(edges[i + k], maxEdge)));
  }
  return count;
}

/** `maxEdge`, or as much more as the budget asks for. */
function allowedLength(edges: EdgeLengths, maxEdge: number, budget: number): number {
  let length = maxEdge;
  while (length < Number.MAX_VALUE && trianglesWhenCut(edges, length) > Math.max(budget, edges.length / 3))
    length *= 1.1;
  return length;
}

const longestPiece = (edges: EdgeLengths, maxEdge: number): number =>
  edges.reduce((longest, length) => Math.max(longest, length / piecesOf(length, maxEdge)), 0);

/** Vertices that are added, each a weighted mean of three old ones, and the triangles between all. */
class Cutter {
  private readonly places: Float32Array;
  private readonly edges: EdgeLengths;
  private readonly maxEdge: number;
  private readonly parents: number[] = [];
  private readonly weights: number[] = [];
  /** First new vertex on an edge, by its ends. */
  private readonly firstOnEdge = new Map<number, number>();
  private readonly indices: number[] = [];
  private readonly groups: readonly MeshGroup[];

  constructor(mesh: Mesh, edges: EdgeLengths, maxEdge: number) {
    this.places = mesh.positions;
    this.edges = edges;
    this.maxEdge = maxEdge;
    this.groups = mesh.groups.map((group) => {
      const start = this.indices.length;
      for (let i = group.start; i + 2 < group.start + group.count; i += 3) this.triangle(mesh.indices, i);
      return { ...group, start, count: this.indices.length - start };
    });
  }

  mesh(from: Mesh): Mesh {
    return {
      positions: this.extended(from.positions, 3),
      normals: this.directions(from.normals),
      uvs: this.extended(from.uvs, 2),
      ...(from.colors ? { colors: this.extended(from.colors, 3) } : {}),
      indices: Uint32Array.from(this.indices),
      groups: this.groups,
      doubleSided: from.doubleSided,
    };
  }

  /** An attribute of the old vertices with those of the new ones appended. */
  extended(data: Float32Array, size: number): Float32Array {
    const old = this.places.length / 3;
    const out = new Float32Array((old + this.parents.length / 3) * size);
    out.set(data);
    for (let v = 0; v < this.parents.length / 3; v++)
      for (let k = 0; k < size; k++) out[(old + v) * size + k] = this.mean(data, v, size, k);
    return out;
  }

  /** As `extended`, for unit vectors. */
  directions(normals: Float32Array): Float32Array {
    const out = this.extended(normals, 3);
    for (let i = normals.length; i < out.length; i += 3) {
      const l = Math.hypot(out[i], out[i + 1], out[i + 2]);
      if (l > 0) for (let k = 0; k < 3; k++) out[i + k] /= l;
    }
    return out;
  }

  private mean(data: Float32Array, v: number, size: number, k: number): number {
    const { parents, weights } = this;
    const part = (j: number) => weights[3 * v + j] * data[parents[3 * v + j] * size + k];
    return weights[3 * v + 2] === 0 ? part(0) + part(1) : part(0) + part(1) + part(2);
  }

  private triangle(indices: Uint32Array, i: number): void {
    const corners: Corners = [indices[i], indices[i + 1], indices[i + 2]];
    const pieces = [0, 1, 2].map((k) => piecesOf(this.edges[i + k], this.maxEdge));
    cutTriangle(corners, pieces, {
      onEdge: (a, b, k, n) => this.onEdge(a, b, k, n),
      inside: (weights) => this.add(corners, weights),
      squaredDistance: (a, b) => this.squaredDistance(a, b),
      emit: (a, b, c) => this.indices.push(a, b, c),
    });
  }

  private add(parents: Corners, weights: Corners): number {
    this.parents.push(...parents);
    this.weights.push(...weights);
    return this.places.length / 3 + this.parents.length / 3 - 1;
  }

  /** The k-th of the n − 1 points between a and b. */
  private onEdge(a: number, b: number, k: number, n: number): number {
    if (k === 0) return a;
    if (k === n) return b;
    if (a > b) return this.onEdge(b, a, n - k, n);
    const key = a * (this.places.length / 3) + b;
    let first = this.firstOnEdge.get(key);
    if (first === undefined) {
      first = this.places.length / 3 + this.parents.length / 3;
      this.firstOnEdge.set(key, first);
      for (let j = 1; j < n; j++) this.addOnEdge(a, b, j / n, (n - j) / n);
    }
    return first + k - 1;
  }

  /** Summed in the order of the ends' places, so that other vertices at the same places give the same point to the last bit. */
  private addOnEdge(a: number, b: number, share: number, rest: number): void {
    if (this.isBefore(a, b)) this.add([a, b, a], [rest, share, 0]);
    else this.add([b, a, b], [share, rest, 0]);
  }

  private isBefore(a: number, b: number): boolean {
    const p = this.places;
    for (let k = 0; k < 3; k++) if (p[3 * a + k] !== p[3 * b + k]) return p[3 * a + k] < p[3 * b + k];
    return a < b;
  }

  private coordinate(v: number, k: number): number {
    const old = this.places.length / 3;
    return v < old ? this.places[3 * v + k] : this.mean(this.places, v - old, 3, k);
  }

  private squaredDistance(a: number, b: number): number {
    let sum = 0;
    for (let k = 0; k < 3; k++) sum += (this.coordinate(a, k) - this.coordinate(b, k)) ** 2;
    return sum;
  }
}
