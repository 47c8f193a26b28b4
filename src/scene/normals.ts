import { cross, dot, length, normalize, scale, sub, type Vec3 } from '../math/vec3.ts';
import { cornersAround, forEachFace, outlineOf, type Polygons, pointAt } from './polygons.ts';
import { newellNormal } from './triangulate.ts';
import type { Mesh } from './types.ts';

/** Around a point with more corners all faces count, however they meet: to compare each with each would take for ever. */
const MOST_COMPARED = 1024;

/**
 * A normal for each corner: the mean, weighted by the angle at the corner, over the faces around its point that meet
 * its own face at less than `smoothAngle` [rad]. 0: flat; π: smooth everywhere.
 *
 * @returns 3 per corner; zero where the face has no area
 */
export function cornerNormals(polygons: Polygons, smoothAngle: number): Float32Array {
  const corners = polygons.faceIndices.length;
  const faceNormal = new Float64Array(corners * 3);
  const weight = new Float64Array(corners);
  forEachFace(polygons, (_, first, count) => measureFace(polygons, first, count, faceNormal, weight));
  if (smoothAngle <= 0) return Float32Array.from(faceNormal);
  return smoothed(faceNormal, weight, polygons.faceIndices, polygons.points.length / 3, Math.cos(smoothAngle));
}

function measureFace(
  polygons: Polygons,
  first: number,
  count: number,
  normals: Float64Array,
  weight: Float64Array,
): void {
  const outline = outlineOf(polygons, first, count);
  const area = newellNormal(outline);
  const n = normalize(polygons.leftHanded ? scale(area, -1) : area);
  for (let k = 0; k < count; k++) {
    const p = outline[k];
    normals.set(n, 3 * (first + k));
    weight[first + k] = angleBetween(sub(outline[(k + 1) % count], p), sub(outline[(k + count - 1) % count], p)) || 0;
  }
}

const angleBetween = (a: Vec3, b: Vec3): number => Math.atan2(length(cross(a, b)), dot(a, b));

function smoothed(
  faceNormal: Float64Array,
  weight: Float64Array,
  pointOfCorner: ArrayLike<number>,
  points: number,
  cosine: number,
): Float32Array {
  const around = cornersAround(pointOfCorner, points);
  const out = new Float32Array(faceNormal.length);
  const sum: [number, number, number] = [0, 0, 0];
  /** Over the corners whose faces meet that of `own` at less than the angle; over all where `own` is none. */
  const addUp = (corners: Uint32Array, own?: number): void => {
    sum.fill(0);
    for (const c of corners) {
      // A face's own normal counts even where rounding puts n·n under the cosine of 0.
      if (own !== undefined && c !== own && dotAt(faceNormal, own, c) < cosine) continue;
      for (let k = 0; k < 3; k++) sum[k] += faceNormal[3 * c + k] * weight[c];
    }
  };
  for (let p = 0; p < points; p++) {
    const corners = around(p);
    const areAllNear = cosine <= -1 || corners.length > MOST_COMPARED;
    if (areAllNear) addUp(corners);
    for (const c of corners) {
      if (!areAllNear) addUp(corners, c);
      out.set(normalize(sum, pointAt(faceNormal, c)), 3 * c);
    }
  }
  return out;
}

const dotAt = (v: ArrayLike<number>, i: number, j: number): number =>
  v[3 * i] * v[3 * j] + v[3 * i + 1] * v[3 * j + 1] + v[3 * i + 2] * v[3 * j + 2];

/**
 * The smoothing groups of a mesh: vertices that share place and normal (a seam of uv or colour lies between them) get
 * one number, that of the first of them, so that the normals of deformed points do not show the seam.
 */
export function smoothingGroups({ positions, normals }: Mesh): Uint32Array {
  // −0 becomes 0; as bits all numbers have an order, NaN too.
  const bits = [positions, normals].map((values) => new Uint32Array(values.map((x) => x + 0).buffer));
  const compare = (v: number, w: number): number => {
    for (const values of bits)
      for (let k = 0; k < 3; k++)
        if (values[3 * v + k] !== values[3 * w + k]) return values[3 * v + k] - values[3 * w + k];
    return 0;
  };
  const order = new Uint32Array(positions.length / 3).map((_, v) => v).sort((v, w) => compare(v, w) || v - w);
  const groups = new Uint32Array(order.length);
  for (let i = 0; i < order.length; i++) {
    const isSame = i > 0 && compare(order[i - 1], order[i]) === 0;
    groups[order[i]] = isSame ? groups[order[i - 1]] : order[i];
  }
  return groups;
}

/** Normals of a mesh with its vertices at `points` (3 per vertex), weighted by area within each smoothing group. */
export function deformedNormals(
  points: ArrayLike<number>,
  indices: ArrayLike<number>,
  groups: Uint32Array,
): Float32Array {
  const sums = new Float64Array(groups.length * 3);
  // Without an object for each triangle: a long cache takes this for every sample that is drawn.
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const a = 3 * indices[i];
    const b = 3 * indices[i + 1];
    const c = 3 * indices[i + 2];
    const ux = points[b] - points[a];
    const uy = points[b + 1] - points[a + 1];
    const uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a];
    const vy = points[c + 1] - points[a + 1];
    const vz = points[c + 2] - points[a + 2];
    for (let k = i; k < i + 3; k++) {
      const at = 3 * groups[indices[k]];
      sums[at] += uy * vz - uz * vy;
      sums[at + 1] += uz * vx - ux * vz;
      sums[at + 2] += ux * vy - uy * vx;
    }
  }
  const out = new Float32Array(groups.length * 3);
  for (let v = 0; v < groups.length; v++) {
    const at = 3 * groups[v];
    const l = length([sums[at], sums[at + 1], sums[at + 2]]);
    if (l > 0) for (let k = 0; k < 3; k++) out[3 * v + k] = sums[at + k] / l;
    else out[3 * v + 2] = 1;
  }
  return out;
}
