import { makeMesh } from '../../scene/mesh/makeMesh.ts';
import { cornerNormals } from '../../scene/mesh/normals.ts';
import type { Polygons } from '../../scene/mesh/polygons.ts';
import type { Mesh } from '../../scene/types.ts';
import { FLAT, type ObjGeometry, type ObjPart } from './geometry.ts';

/** Texture transform (u, v) · scale + offset (options -s and -o of the map). */
export interface UvPlacement {
  readonly scale: readonly [number, number];
  readonly offset: readonly [number, number];
}

export interface FaceMaterial {
  /** Index in `Scene.materials`. */
  readonly place: number;
  readonly uvs?: UvPlacement;
}

/** The mesh of a part; `faceMaterials` by index in `ObjGeometry.materials`. */
export function meshOf(geometry: ObjGeometry, part: ObjPart, faceMaterials: readonly FaceMaterial[]): Mesh {
  const corners = part.corners.values();
  const own = ownPoints(geometry, corners);
  const faces = { points: own.points, faceCounts: part.counts.values(), faceIndices: own.indices };
  const uvs = cornerUvs(geometry, part, corners, faceMaterials);
  const polygons: Polygons = {
    ...faces,
    normals: { per: 'corner', values: allNormals(geometry, part, corners, faces) },
    ...(uvs && { uvs: { per: 'corner', values: uvs } }),
    ...(own.colors && { colors: { per: 'point', values: own.colors } }),
    faceMaterials: part.materials.values().map((material) => faceMaterials[material].place),
    // The format does not specify the winding order, and files differ.
    doubleSided: true,
  };
  return makeMesh(polygons).mesh;
}

/** The points that a part uses, in order of first use; a file has one list for all its parts. */
function ownPoints(geometry: ObjGeometry, corners: Int32Array) {
  const [points, colors] = [geometry.points.values(), geometry.colors.values()];
  const places = new Map<number, number>();
  const indices = new Uint32Array(corners.length / 3);
  for (let c = 0; c < indices.length; c++) {
    const point = corners[3 * c];
    const place = places.get(point) ?? places.size;
    places.set(point, place);
    indices[c] = place;
  }
  const gathered = (value: (at: number) => number): Float32Array => {
    const out = new Float32Array(3 * places.size);
    for (const [point, place] of places) for (let k = 0; k < 3; k++) out[3 * place + k] = value(3 * point + k);
    return out;
  };
  const color = (at: number): number => (at < colors.length ? geometry.linear(colors[at]) : 1);
  return { indices, points: gathered((at) => points[at]), colors: colors.length > 0 ? gathered(color) : undefined };
}

function cornerUvs(
  { uvs }: ObjGeometry,
  part: ObjPart,
  corners: Int32Array,
  faceMaterials: readonly FaceMaterial[],
): Float32Array | undefined {
  if (uvs.length === 0) return undefined;
  const [from, materials] = [uvs.values(), part.materials.values()];
  const out = new Float32Array((2 * corners.length) / 3);
  forEachCorner(part, (face, c) => {
    const uv = corners[3 * c + 1];
    if (uv < 0) return;
    const placed = faceMaterials[materials[face]].uvs;
    for (let k = 0; k < 2; k++) {
      const value = from[2 * uv + k];
      out[2 * c + k] = placed ? value * placed.scale[k] + placed.offset[k] : value;
    }
  });
  return out;
}

type ObjFaces = Pick<Polygons, 'points' | 'faceCounts' | 'faceIndices'>;

/** Normals as authored; missing ones computed from the smoothing groups. */
function allNormals({ normals }: ObjGeometry, part: ObjPart, corners: Int32Array, faces: ObjFaces): Float32Array {
  const from = normals.values();
  const out = new Float32Array(corners.length);
  let isWhole = true;
  for (let c = 0; c < corners.length / 3; c++) {
    const normal = corners[3 * c + 2];
    if (normal < 0) isWhole = false;
    else for (let k = 0; k < 3; k++) out[3 * c + k] = from[3 * normal + k];
  }
  if (!isWhole) {
    const computed = smoothNormals(part, faces);
    for (let c = 0; c < corners.length / 3; c++) {
      if (corners[3 * c + 2] >= 0) continue;
      for (let k = 3 * c; k < 3 * c + 3; k++) out[k] = computed[k];
    }
  }
  return out;
}

/**
 * Normals that are smooth within each smoothing group; faces of group 0 are flat. Each point is duplicated per group, and
 * per corner in group 0; then all duplicates are shaded smooth.
 */
function smoothNormals(part: ObjPart, faces: ObjFaces): Float32Array {
  const smoothing = part.smoothing.values();
  const groups = new Map<number, number>();
  const places = new Map<number, number>();
  const points: number[] = [];
  const faceIndices = new Uint32Array(faces.faceIndices.length);
  const add = (point: number): number => {
    for (let k = 0; k < 3; k++) points.push(faces.points[3 * point + k]);
    return points.length / 3 - 1;
  };
  forEachCorner(part, (face, c) => {
    const point = faces.faceIndices[c];
    const group = smoothing[face];
    const row = groups.get(group) ?? groups.size;
    groups.set(group, row);
    const key = (row * faces.points.length) / 3 + point;
    faceIndices[c] = places.get(key) ?? add(point);
    if (group !== FLAT) places.set(key, faceIndices[c]);
  });
  return cornerNormals({ points, faceCounts: faces.faceCounts, faceIndices }, Math.PI);
}

function forEachCorner(part: ObjPart, visit: (face: number, corner: number) => void): void {
  const counts = part.counts.values();
  let corner = 0;
  for (let face = 0; face < counts.length; face++) for (let k = 0; k < counts[face]; k++) visit(face, corner++);
}
