import { cross, dot, normalize, sub, type Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../mesh/polygons.ts';

/** Polygons by their corner counts. */
export interface PolygonFaces {
  readonly counts: readonly number[];
  /** Point indices of all corners, face by face. */
  readonly corners: readonly number[];
}

/** A side counts as the longest if the others are shorter by this fraction. */
const LONGER = 1e-4;
/** 1 − cos of the largest angle between triangles that count as coplanar. */
const FLAT = 1e-6;

/**
 * Joins pairs of coplanar triangles that share their longest side into quads, as they were before a reader triangulated them. Triangles without three different
 * points are omitted. `points`: 3 numbers each.
 */
export function recoverQuads(points: ArrayLike<number>, triangles: ArrayLike<number>): PolygonFaces {
  const faces = facesOf(points, triangles);
  const bySide = new Map<string, Triangle>();
  const partners = new Map<Triangle, Triangle>();
  for (const face of faces) {
    if (!face.longest) continue;
    const key = face.longest.toSorted((a, b) => a - b).join(' ');
    const other = bySide.get(key);
    if (!other) bySide.set(key, face);
    else if (!partners.has(other) && dot(face.normal, other.normal) > 1 - FLAT) {
      partners.set(face, other);
      partners.set(other, face);
    }
  }
  const polygons = faces.flatMap((face) => {
    const partner = partners.get(face);
    if (!partner) return [face.corners];
    const [a, b] = face.longest!;
    return face.index > partner.index ? [] : [[a, apex(partner), b, apex(face)]];
  });
  return { counts: polygons.map(({ length }) => length), corners: polygons.flat() };
}

interface Triangle {
  readonly index: number;
  readonly corners: readonly number[];
  readonly normal: Vec3;
  /** In the triangle's winding order; absent if no side is longer than the others. */
  readonly longest?: readonly [number, number];
}

function facesOf(points: ArrayLike<number>, triangles: ArrayLike<number>): Triangle[] {
  const faces: Triangle[] = [];
  for (let i = 0; i + 2 < triangles.length; i += 3) {
    const corners = [triangles[i], triangles[i + 1], triangles[i + 2]];
    if (new Set(corners).size < 3) continue;
    const sides = corners.map((from, k) => sub(pointAt(points, corners[(k + 1) % 3]), pointAt(points, from)));
    const lengths = sides.map((side) => Math.hypot(...side));
    const k = lengths.indexOf(Math.max(...lengths));
    const isLongest = lengths.every((length, j) => j === k || length < (1 - LONGER) * lengths[k]);
    faces.push({
      index: i,
      corners,
      normal: normalize(cross(sides[0], sides[1])),
      ...(isLongest && { longest: [corners[k], corners[(k + 1) % 3]] }),
    });
  }
  return faces;
}

const apex = ({ corners, longest }: Triangle): number => corners.find((corner) => !longest!.includes(corner))!;
