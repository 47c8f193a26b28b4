import { norm } from '../../math/vec3.ts';
import type { Mesh } from '../types.ts';
import { cornerNormals, faceNormals } from './normals.ts';
import { forEachFace, outlineOf, type Polygons, type PolygonValues } from './polygons.ts';
import { triangulate } from './triangulate.ts';

/** A mesh, and which points its vertices were. */
export interface BuiltMesh {
  /** Its triangles. */
  readonly mesh: Mesh;
  /** By vertex: the index of its point, for meshes whose points deform. */
  readonly pointOfVertex: Uint32Array;
}

/**
 * Triangulates polygons. A point becomes several vertices if its corners differ in normal, uv or colour. Faces with fewer than three corners, or with invalid
 * point indices, are skipped and counted.
 * @example
 * // A square of two triangles.
 * const { mesh } = makeMesh({
 *   points: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
 *   faceCounts: [4],
 *   faceIndices: [0, 1, 2, 3],
 * });
 * mesh.indices.length; // 6
 * mesh.normals; // [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]
 */
export function makeMesh(polygons: Polygons): BuiltMesh & { readonly skippedFaces: number } {
  const { groups, groupOfFace, skippedFaces, total } = groupFaces(polygons);
  const welder = new VertexWelder(polygons);
  const indices = new Uint32Array(total);
  const next = Uint32Array.from(groups, ({ start }) => start);
  const step = polygons.leftHanded ? -1 : 1;
  let outline: Float64Array = new Float64Array(12);
  forEachFace(polygons, (face, first, count) => {
    const group = groupOfFace[face];
    if (group < 0) return;
    // Triangles need no triangulation, so their outline is not read.
    if (count > 3) outline = outlineOf(polygons, first, count, outline);
    if (count > 3 && polygons.leftHanded) turnRound(outline, count);
    const cut = triangulate(outline, count);
    const corner = polygons.leftHanded ? first + count - 1 : first;
    for (let i = 0; i < cut.length; i++) indices[next[group]++] = welder.vertex(corner + step * cut[i], face);
  });
  return { ...welder.finish({ indices, groups }), skippedFaces };
}

/** Groups the faces by material, in order of first use, with the offsets of their triangles. */
function groupFaces(polygons: Polygons) {
  const { faceMaterials } = polygons;
  const groups: { start: number; count: number; material: number }[] = [];
  const groupOfMaterial = new Map<number, number>();
  const groupOfFace = new Int32Array(polygons.faceCounts.length).fill(-1);
  let skippedFaces = 0;
  forEachFace(polygons, (face, first, count) => {
    if (count < 3 || !cornersExist(polygons, first, count)) {
      skippedFaces++;
      return;
    }
    const material = faceMaterials?.[face] ?? 0;
    const group = groupOfMaterial.get(material) ?? groups.push({ start: 0, count: 0, material }) - 1;
    groupOfMaterial.set(material, group);
    groupOfFace[face] = group;
    groups[group].count += 3 * (count - 2);
  });
  let total = 0;
  for (const group of groups) {
    group.start = total;
    total += group.count;
  }
  return { groups, groupOfFace, skippedFaces, total };
}

function cornersExist({ points, faceIndices }: Polygons, first: number, count: number): boolean {
  for (let c = first; c < first + count; c++) {
    const p = faceIndices[c];
    if (!(p >= 0 && 3 * p < points.length)) return false;
  }
  return true;
}

/** Reverses the corners of an outline. */
function turnRound(outline: Float64Array, count: number): void {
  for (let a = 0, b = 3 * count - 3; a < b; a += 3, b -= 3)
    for (let k = 0; k < 3; k++) [outline[a + k], outline[b + k]] = [outline[b + k], outline[a + k]];
}

/** Most vertices of a point that are compared with a corner; comparing all could take quadratic time and would save little. */
const MAX_COMPARED_VERTICES = 64;

/** Gives corners with the same point, normal, uv and colour the same vertex. */
class VertexWelder {
  private readonly polygons: Polygons;
  private readonly normals: VertexValues;
  private readonly uvs: VertexValues | undefined;
  private readonly colors: VertexValues | undefined;
  /** Values in which corners of one point may differ, and those in which they may not. */
  private readonly differing: readonly VertexValues[];
  private readonly shared: readonly VertexValues[];
  private readonly vertexOfCorner: Int32Array;
  /** Linked lists of the vertices of each point: the last one, and from each to the previous. */
  private readonly lastOfPoint: Int32Array;
  private readonly before: Int32Array;
  private readonly pointOf: Uint32Array;
  private size = 0;

  constructor(polygons: Polygons) {
    const { uvs, colors, faceIndices } = polygons;
    const corners = faceIndices.length;
    this.polygons = polygons;
    this.normals = new VertexValues(polygons.normals ?? computedNormals(polygons), 3, corners);
    this.uvs = uvs && new VertexValues(uvs, 2, corners);
    this.colors = colors && new VertexValues(colors, 3, corners);
    const all = [this.normals, this.uvs, this.colors].filter((values) => values !== undefined);
    this.differing = all.filter(({ differs }) => differs);
    this.shared = all.filter(({ differs }) => !differs);
    this.vertexOfCorner = new Int32Array(corners).fill(-1);
    this.lastOfPoint = new Int32Array(polygons.points.length / 3).fill(-1);
    this.before = new Int32Array(corners);
    this.pointOf = new Uint32Array(corners);
  }

  vertex(corner: number, face: number): number {
    const existing = this.vertexOfCorner[corner];
    if (existing >= 0) return existing;
    const v = this.find(corner, face);
    this.vertexOfCorner[corner] = v;
    return v;
  }

  /** Appends a vertex; if an equal one exists, the next overwrites it. */
  private find(corner: number, face: number): number {
    const v = this.size;
    const point = this.polygons.faceIndices[corner];
    for (let i = 0; i < this.differing.length; i++) this.differing[i].write(v, corner, face, point);
    let w = this.lastOfPoint[point];
    for (let compared = 0; w >= 0 && compared < MAX_COMPARED_VERTICES; w = this.before[w], compared++)
      if (this.areSame(v, w)) return w;
    for (let i = 0; i < this.shared.length; i++) this.shared[i].write(v, corner, face, point);
    this.pointOf[v] = point;
    this.before[v] = this.lastOfPoint[point];
    this.lastOfPoint[point] = v;
    this.size++;
    return v;
  }

  private areSame(v: number, w: number): boolean {
    for (let i = 0; i < this.differing.length; i++) if (!this.differing[i].areSame(v, w)) return false;
    return true;
  }

  finish(triangles: Pick<Mesh, 'indices' | 'groups'>): BuiltMesh {
    const n = this.size;
    const pointOfVertex = this.pointOf.slice(0, n);
    const mesh: Mesh = {
      positions: gatherPoints(this.polygons.points, pointOfVertex),
      normals: unitNormals(this.normals.first(n)),
      uvs: this.uvs?.first(n) ?? new Float32Array(2 * n),
      ...(this.colors && { colors: this.colors.first(n) }),
      ...triangles,
      doubleSided: this.polygons.doubleSided === true,
    };
    return { mesh, pointOfVertex };
  }
}

const computedNormals = (polygons: Polygons): PolygonValues =>
  polygons.smoothAngle !== undefined && polygons.smoothAngle > 0
    ? { per: 'corner', values: cornerNormals(polygons, polygons.smoothAngle) }
    : { per: 'face', values: faceNormals(polygons) };

/** One kind of values, gathered from polygons to vertices. */
class VertexValues {
  /** Whether corners of one point can have different values. */
  readonly differs: boolean;
  private readonly from: PolygonValues;
  private readonly size: number;
  private readonly values: Float32Array;

  /** @param size numbers per value */
  constructor(from: PolygonValues, size: number, maxVertices: number) {
    this.from = from;
    this.size = size;
    this.differs = from.per === 'corner' || from.per === 'face';
    this.values = new Float32Array(maxVertices * size);
  }

  write(vertex: number, corner: number, face: number, point: number): void {
    const { per, values, indices } = this.from;
    const place = per === 'point' ? point : per === 'corner' ? corner : per === 'face' ? face : 0;
    const index = indices ? indices[place] : place;
    for (let k = 0; k < this.size; k++) this.values[vertex * this.size + k] = values[index * this.size + k] ?? 0;
  }

  areSame(v: number, w: number): boolean {
    for (let k = 0; k < this.size; k++)
      if (this.values[v * this.size + k] !== this.values[w * this.size + k]) return false;
    return true;
  }

  /** The values of the first `vertices` vertices. */
  first(vertices: number): Float32Array {
    const numbers = vertices * this.size;
    return numbers === this.values.length ? this.values : this.values.slice(0, numbers);
  }
}

/** Gathers points by vertex: for the rest shape, and for each sample of a deforming mesh. */
export function gatherPoints(points: ArrayLike<number>, pointOfVertex: ArrayLike<number>): Float32Array {
  const out = new Float32Array(pointOfVertex.length * 3);
  for (let v = 0; v < pointOfVertex.length; v++) {
    const p = pointOfVertex[v] * 3;
    out[3 * v] = points[p];
    out[3 * v + 1] = points[p + 1];
    out[3 * v + 2] = points[p + 2];
  }
  return out;
}

function unitNormals(normals: Float32Array): Float32Array {
  for (let i = 0; i < normals.length; i += 3) {
    const l = norm(normals[i], normals[i + 1], normals[i + 2]);
    const isNone = !(l > 0);
    normals[i] = isNone ? 0 : normals[i] / l;
    normals[i + 1] = isNone ? 0 : normals[i + 1] / l;
    normals[i + 2] = isNone ? 1 : normals[i + 2] / l;
  }
  return normals;
}
