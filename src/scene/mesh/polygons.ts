import type { Vec3 } from '../../math/vec3.ts';

/** Polygons as in modelling programs: points, faces as runs of corners, and values per point, corner or face. */
export interface Polygons {
  /** [m], 3 per point. */
  readonly points: ArrayLike<number>;
  /** Corners per face. */
  readonly faceCounts: ArrayLike<number>;
  /** The point of each corner. */
  readonly faceIndices: ArrayLike<number>;
  /** 3 per value. Absent: computed with `smoothAngle`. */
  readonly normals?: PolygonValues;
  /** 2 per value; absent: zero. */
  readonly uvs?: PolygonValues;
  /** Linear RGB, 3 per value. */
  readonly colors?: PolygonValues;
  /** By face: index in `Scene.materials`; absent: material 0. */
  readonly faceMaterials?: ArrayLike<number>;
  /** Whether faces are clockwise seen from outside. */
  readonly leftHanded?: boolean;
  /** Whether faces are seen from both sides. */
  readonly doubleSided?: boolean;
  /** Computed normals are smooth between faces that meet at less than this angle [rad]: 0 is flat, π is smooth everywhere. Default 0. */
  readonly smoothAngle?: number;
}

/** Values of points, corners or faces, or one for all. */
export interface PolygonValues {
  /** What has a value each. */
  readonly per: 'point' | 'corner' | 'face' | 'constant';
  /** As many numbers a value as the field says. */
  readonly values: ArrayLike<number>;
  /** Index in `values` of each point, corner or face; absent: in order. */
  readonly indices?: ArrayLike<number>;
  /** For values per point: whether a subdivision surface interpolates them linearly instead of like its points. */
  readonly linear?: boolean;
}

/** Iterates over the faces: index, first corner and corner count. */
export function forEachFace(
  polygons: Pick<Polygons, 'faceCounts' | 'faceIndices'>,
  visit: (face: number, firstCorner: number, count: number) => void,
): void {
  let first = 0;
  for (let face = 0; face < polygons.faceCounts.length; face++) {
    const count = polygons.faceCounts[face];
    if (first + count <= polygons.faceIndices.length) visit(face, first, count);
    first += count;
  }
}

export const pointAt = (points: ArrayLike<number>, i: number): Vec3 => [
  points[3 * i],
  points[3 * i + 1],
  points[3 * i + 2],
];

/** The points of a face in order, 3 numbers each; reuses `into` if it is large enough. */
export function outlineOf(
  { points, faceIndices }: Polygons,
  firstCorner: number,
  count: number,
  into?: Float64Array,
): Float64Array {
  const outline = into && into.length >= 3 * count ? into : new Float64Array(3 * count);
  for (let k = 0; k < count; k++) {
    const p = 3 * faceIndices[firstCorner + k];
    outline[3 * k] = points[p];
    outline[3 * k + 1] = points[p + 1];
    outline[3 * k + 2] = points[p + 2];
  }
  return outline;
}

/** Point → its corners: those of point p are `corners[start[p]]` up to `start[p + 1]`. By counting sort. */
export function cornerRuns(pointOfCorner: ArrayLike<number>, points: number) {
  const start = new Uint32Array(points + 1);
  for (let c = 0; c < pointOfCorner.length; c++) start[pointOfCorner[c] + 1]++;
  for (let p = 0; p < points; p++) start[p + 1] += start[p];
  const fill = start.slice();
  const corners = new Uint32Array(pointOfCorner.length);
  for (let c = 0; c < pointOfCorner.length; c++) corners[fill[pointOfCorner[c]]++] = c;
  return { start, corners };
}

/** The same as a function of the point. */
export function cornersAround(pointOfCorner: ArrayLike<number>, points: number): (point: number) => Uint32Array {
  const { start, corners } = cornerRuns(pointOfCorner, points);
  return (point) => corners.subarray(start[point], start[point + 1]);
}
