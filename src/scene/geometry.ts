import { length } from '../math/vec3.ts';
import { cornerNormals } from './normals.ts';
import { forEachFace, outlineOf, type Polygons, type PolygonValues } from './polygons.ts';
import { triangulate } from './triangulate.ts';
import type { Mesh, MeshGroup } from './types.ts';

export interface BuiltMesh {
  readonly mesh: Mesh;
  /** The point each vertex came from, so that deformed points can follow. */
  readonly pointOfVertex: Uint32Array;
}

/**
 * Triangles from polygons. A point becomes several vertices where its corners differ in normal, uv or colour.
 * Faces with fewer than three corners, or with corners that name no point, are left out and counted.
 */
export function makeMesh(polygons: Polygons): BuiltMesh & { readonly skippedFaces: number } {
  const corners = polygons.faceIndices.length;
  const welder = new VertexWelder(polygons, corners);
  const byMaterial = new Map<number, number[]>();
  let skippedFaces = 0;
  forEachFace(polygons, (face, first, count) => {
    if (count < 3 || !cornersExist(polygons, first, count)) {
      skippedFaces++;
      return;
    }
    const material = polygons.faceMaterials?.[face] ?? 0;
    const run = byMaterial.get(material) ?? [];
    byMaterial.set(material, run);
    appendFace(run, polygons, welder, face, first, count);
  });
  return { ...welder.finish(byMaterial), skippedFaces };
}

function cornersExist(polygons: Polygons, first: number, count: number): boolean {
  const points = polygons.points.length / 3;
  for (let c = first; c < first + count; c++) {
    const p = polygons.faceIndices[c];
    if (!(p >= 0 && p < points)) return false;
  }
  return true;
}

function appendFace(
  run: number[],
  polygons: Polygons,
  welder: VertexWelder,
  face: number,
  first: number,
  count: number,
): void {
  const flip = polygons.leftHanded === true;
  const corner = (k: number): number => (flip ? first + count - 1 - k : first + k);
  if (count === 3) {
    for (let k = 0; k < 3; k++) run.push(welder.vertex(corner(k), face));
    return;
  }
  const outline = outlineOf(polygons, first, count);
  for (const k of triangulate(flip ? outline.reverse() : outline)) run.push(welder.vertex(corner(k), face));
}

/** How many vertices of a point are compared with a corner; welding more would save little, and could take for ever. */
const MOST_COMPARED = 64;

/** Gives corners with the same point, normal, uv and colour the same vertex. */
class VertexWelder {
  private readonly polygons: Polygons;
  private readonly normals: PolygonValues;
  private readonly firstOfPoint: Int32Array;
  private readonly next: Int32Array;
  private readonly pointOf: Uint32Array;
  private readonly values: Float32Array;
  private readonly scratch: Float32Array;
  private readonly stride: number;
  private size = 0;

  constructor(polygons: Polygons, corners: number) {
    this.polygons = polygons;
    this.normals = polygons.normals ?? { per: 'corner', values: cornerNormals(polygons, polygons.smoothAngle ?? 0) };
    this.stride = polygons.colors ? 8 : 5;
    this.firstOfPoint = new Int32Array(polygons.points.length / 3).fill(-1);
    this.next = new Int32Array(corners).fill(-1);
    this.pointOf = new Uint32Array(corners);
    this.values = new Float32Array(corners * this.stride);
    this.scratch = new Float32Array(this.stride);
  }

  vertex(corner: number, face: number): number {
    const point = this.polygons.faceIndices[corner];
    this.readCorner(corner, face, point);
    let compared = 0;
    for (let v = this.firstOfPoint[point]; v >= 0 && compared < MOST_COMPARED; v = this.next[v], compared++) {
      if (this.matches(v)) return v;
    }
    const v = this.size++;
    this.pointOf[v] = point;
    this.values.set(this.scratch, v * this.stride);
    this.next[v] = this.firstOfPoint[point];
    this.firstOfPoint[point] = v;
    return v;
  }

  private readCorner(corner: number, face: number, point: number): void {
    const { uvs, colors } = this.polygons;
    this.readValue(this.normals, 3, 0, corner, face, point);
    if (uvs) this.readValue(uvs, 2, 3, corner, face, point);
    if (colors) this.readValue(colors, 3, 5, corner, face, point);
  }

  private readValue(from: PolygonValues, size: number, at: number, corner: number, face: number, point: number): void {
    const place = from.per === 'point' ? point : from.per === 'corner' ? corner : from.per === 'face' ? face : 0;
    const index = from.indices ? from.indices[place] : place;
    for (let k = 0; k < size; k++) this.scratch[at + k] = from.values[index * size + k] ?? 0;
  }

  private matches(v: number): boolean {
    for (let k = 0; k < this.stride; k++) if (this.values[v * this.stride + k] !== this.scratch[k]) return false;
    return true;
  }

  finish(byMaterial: ReadonlyMap<number, readonly number[]>): BuiltMesh {
    const n = this.size;
    const pointOfVertex = this.pointOf.slice(0, n);
    const take = (size: number, at: number) => {
      const out = new Float32Array(n * size);
      for (let v = 0; v < n; v++)
        for (let k = 0; k < size; k++) out[v * size + k] = this.values[v * this.stride + at + k];
      return out;
    };
    const mesh: Mesh = {
      positions: gatherPoints(this.polygons.points, pointOfVertex),
      normals: unitNormals(take(3, 0)),
      uvs: take(2, 3),
      ...(this.polygons.colors ? { colors: take(3, 5) } : {}),
      ...groupIndices(byMaterial),
      doubleSided: this.polygons.doubleSided === true,
    };
    return { mesh, pointOfVertex };
  }
}

/** The points of the vertices: for the rest shape, and for each sample of a deforming one. */
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
    const l = length([normals[i], normals[i + 1], normals[i + 2]]);
    if (!(l > 0)) normals.set([0, 0, 1], i);
    else for (let k = 0; k < 3; k++) normals[i + k] = normals[i + k] / l;
  }
  return normals;
}

function groupIndices(byMaterial: ReadonlyMap<number, readonly number[]>): Pick<Mesh, 'indices' | 'groups'> {
  let total = 0;
  for (const run of byMaterial.values()) total += run.length;
  const indices = new Uint32Array(total);
  const groups: MeshGroup[] = [];
  let start = 0;
  for (const [material, run] of byMaterial) {
    if (run.length === 0) continue;
    indices.set(run, start);
    groups.push({ start, count: run.length, material });
    start += run.length;
  }
  return { indices, groups };
}
