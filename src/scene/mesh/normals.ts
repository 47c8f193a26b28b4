import { norm, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import type { Mesh } from '../types.ts';
import { cornerRuns, forEachFace, outlineOf, type Polygons } from './polygons.ts';
import { newellNormal } from './triangulate.ts';

/** Around points with more corners, faces are smoothed at any angle: comparing all pairs would take quadratic time. */
const MAX_COMPARED_CORNERS = 1024;

/** The normal of each face, 3 numbers; zero for faces without area. */
export function faceNormals(polygons: Polygons): Float32Array {
  const normals = new Float32Array(polygons.faceCounts.length * 3);
  let outline: Float64Array = new Float64Array(12);
  forEachFace(polygons, (face, first, count) => {
    outline = outlineOf(polygons, first, count, outline);
    put(normals, face, faceNormal(polygons, outline, count));
  });
  return normals;
}

/** Faster than `set`. */
function put(into: Float32Array | Float64Array, i: number, v: Vec3): void {
  into[3 * i] = v[0];
  into[3 * i + 1] = v[1];
  into[3 * i + 2] = v[2];
}

function faceNormal({ leftHanded }: Polygons, outline: Float64Array, count: number): Vec3 {
  const area = newellNormal(outline, count);
  return normalize(leftHanded ? scale(area, -1) : area);
}

/**
 * The normal of each corner: the mean, weighted by the angle at the corner, over the faces around its point that meet its own face at less than `smoothAngle`
 * [rad]. 0: flat; π: smooth everywhere.
 *
 * @returns 3 numbers per corner; zero for faces without area
 */
export function cornerNormals(polygons: Polygons, smoothAngle: number): Float32Array {
  const corners = polygons.faceIndices.length;
  const own = new Float64Array(corners * 3);
  const weight = new Float64Array(corners);
  let outline: Float64Array = new Float64Array(12);
  forEachFace(polygons, (_, first, count) => {
    outline = outlineOf(polygons, first, count, outline);
    const n = faceNormal(polygons, outline, count);
    for (let k = 0; k < count; k++) {
      put(own, first + k, n);
      weight[first + k] = angleAt(outline, k, count) || 0;
    }
  });
  if (smoothAngle <= 0) return new Float32Array(own);
  return smoothed(own, weight, polygons.faceIndices, polygons.points.length / 3, Math.cos(smoothAngle));
}

/** The angle between the two sides at a corner [rad]. */
function angleAt(outline: Float64Array, corner: number, count: number): number {
  const p = 3 * corner;
  const next = corner + 1 < count ? p + 3 : 0;
  const last = corner > 0 ? p - 3 : 3 * count - 3;
  const ux = outline[next] - outline[p];
  const uy = outline[next + 1] - outline[p + 1];
  const uz = outline[next + 2] - outline[p + 2];
  const vx = outline[last] - outline[p];
  const vy = outline[last + 1] - outline[p + 1];
  const vz = outline[last + 2] - outline[p + 2];
  return Math.atan2(norm(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx), ux * vx + uy * vy + uz * vz);
}

/** @param own the face normal of each corner */
function smoothed(
  own: Float64Array,
  weight: Float64Array,
  pointOfCorner: ArrayLike<number>,
  points: number,
  cosine: number,
): Float32Array {
  const { start, corners } = cornerRuns(pointOfCorner, points);
  const out = new Float32Array(own.length);
  const sum = new Float64Array(3);
  for (let p = 0; p < points; p++) {
    const around = corners.subarray(start[p], start[p + 1]);
    const areAllNear = cosine <= -1 || around.length > MAX_COMPARED_CORNERS;
    for (let i = 0; i < around.length; i++) {
      if (!areAllNear || i === 0) addUp(sum, own, weight, around, around[i], areAllNear ? -Infinity : cosine);
      const c = 3 * around[i];
      const l = norm(sum[0], sum[1], sum[2]);
      for (let k = 0; k < 3; k++) out[c + k] = l > 0 ? sum[k] / l : own[c + k];
    }
  }
  return out;
}

/** Adds the weighted normals of the corners around a point whose faces meet that of corner c at less than the angle. */
function addUp(
  sum: Float64Array,
  own: Float64Array,
  weight: Float64Array,
  around: Uint32Array,
  c: number,
  cosine: number,
): void {
  sum.fill(0);
  for (let i = 0; i < around.length; i++) {
    const d = around[i];
    const dot = own[3 * c] * own[3 * d] + own[3 * c + 1] * own[3 * d + 1] + own[3 * c + 2] * own[3 * d + 2];
    // A face's own normal always counts: rounding may make n·n less than the cosine of 0.
    if (dot < cosine && c !== d) continue;
    for (let k = 0; k < 3; k++) sum[k] += own[3 * d + k] * weight[d];
  }
}

/** Most groups of a hash bucket that are compared with a vertex; only malicious files have more. */
const MAX_BUCKET_SIZE = 64;

/**
 * The smoothing groups of a mesh: vertices with equal position and normal, which a seam of uvs or colours separates, get the index of the first of them, so that
 * normals of deformed points do not show the seam.
 */
export function smoothingGroups({ positions, normals }: Mesh): Uint32Array {
  const [p, n] = [bitsOf(positions), bitsOf(normals)];
  const vertices = positions.length / 3;
  const buckets = new Int32Array(2 ** Math.ceil(Math.log2(vertices + 1))).fill(-1);
  const next = new Int32Array(vertices);
  const groups = new Uint32Array(vertices);
  for (let v = 0; v < vertices; v++) {
    const bucket = hashVertex(n, v, hashVertex(p, v, 0)) & (buckets.length - 1);
    let w = buckets[bucket];
    for (let i = 0; w >= 0 && !(areSame(p, v, w) && areSame(n, v, w)); i++) w = i < MAX_BUCKET_SIZE ? next[w] : -1;
    groups[v] = w < 0 ? v : w;
    if (w >= 0) continue;
    next[v] = buckets[bucket];
    buckets[bucket] = v;
  }
  return groups;
}

/** Numbers as bits, so that NaN equals NaN; −0 is replaced by 0. */
function bitsOf(numbers: Float32Array): Uint32Array {
  const bits = new Uint32Array(numbers.buffer, numbers.byteOffset, numbers.length).slice();
  for (let i = 0; i < bits.length; i++) if (bits[i] === 0x80000000) bits[i] = 0;
  return bits;
}

const areSame = (bits: Uint32Array, v: number, w: number): boolean =>
  bits[3 * v] === bits[3 * w] && bits[3 * v + 1] === bits[3 * w + 1] && bits[3 * v + 2] === bits[3 * w + 2];

/** Mixes the three numbers of vertex v into a hash. Source: the rounds of MurmurHash3, Appleby 2011. */
function hashVertex(bits: Uint32Array, v: number, hash: number): number {
  let h = hash;
  for (let i = 3 * v; i < 3 * v + 3; i++) {
    h = Math.imul(h ^ bits[i], 0x85ebca6b);
    h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
    h ^= h >>> 16;
  }
  return h;
}

/** Reused buffers for the sums at the vertices of a mesh: allocating them for each sample would take longer than adding. */
const SUMS = new WeakMap<Uint32Array, Float64Array>();

function emptySums(groups: Uint32Array): Float64Array {
  const cached = SUMS.get(groups);
  if (cached) return cached.fill(0);
  const sums = new Float64Array(groups.length * 3);
  SUMS.set(groups, sums);
  return sums;
}

/** Normals of a mesh with its vertices at `points` (3 per vertex), weighted by area within each smoothing group. */
export function deformedNormals(
  points: ArrayLike<number>,
  indices: ArrayLike<number>,
  groups: Uint32Array,
): Float32Array {
  const sums = emptySums(groups);
  // Allocates no objects per triangle, because this runs for every drawn sample of long caches.
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
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    for (let k = i; k < i + 3; k++) {
      const at = 3 * groups[indices[k]];
      sums[at] += x;
      sums[at + 1] += y;
      sums[at + 2] += z;
    }
  }
  return directions(sums, groups);
}

/** Normalizes each vertex's sum, which is that of its group. */
function directions(sums: Float64Array, groups: Uint32Array): Float32Array {
  const out = new Float32Array(groups.length * 3);
  for (let v = 0; v < groups.length; v++) {
    const at = 3 * groups[v];
    const x = sums[at];
    const y = sums[at + 1];
    const z = sums[at + 2];
    const l = norm(x, y, z);
    if (!(l > 0)) {
      out[3 * v + 2] = 1;
      continue;
    }
    out[3 * v] = x / l;
    out[3 * v + 1] = y / l;
    out[3 * v + 2] = z / l;
  }
  return out;
}
