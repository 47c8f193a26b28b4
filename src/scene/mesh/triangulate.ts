import earcut from 'earcut';
import { cross, dot, normalize, sub, type Vec3 } from '../../math/vec3.ts';
import { pointAt } from './polygons.ts';

const TRIANGLE = [0, 1, 2];
/** A quad, split at corner 0 or corner 1. */
const FROM_ZERO = [0, 1, 2, 0, 2, 3];
const FROM_ONE = [0, 1, 3, 1, 2, 3];

/**
 * Splits one polygon into triangles that keep its winding and use every corner of its outline, so that there are no T-junctions with neighbours (which relativity
 * would open into cracks). Concave and non-planar polygons are triangulated in the plane of their Newell normal.
 *
 * @param outline corners in order, 3 numbers each [m]; it may be longer than `count` of them
 * @returns triples of indices in `outline`, `count` − 2 of them
 */
export function triangulate(outline: ArrayLike<number>, count: number): readonly number[] {
  if (count < 3) return [];
  if (count === 3) return TRIANGLE;
  if (count === 4) return splitQuad(outline);
  const flat = projected(outline, count, newellNormal(outline, count));
  return withDroppedCorners(earcut(flat), count) ?? fan(count);
}

/** Twice the polygon's vector area; its direction is the normal of a counter-clockwise outline (Newell's method). */
export function newellNormal(outline: ArrayLike<number>, count: number): Vec3 {
  const twoX = 2 * outline[0];
  const twoY = 2 * outline[1];
  const twoZ = 2 * outline[2];
  let x = 0;
  let y = 0;
  let z = 0;
  for (let k = 0; k < count; k++) {
    const a = 3 * k;
    const b = k + 1 < count ? a + 3 : 0;
    x += (outline[a + 1] - outline[b + 1]) * (outline[a + 2] + outline[b + 2] - twoZ);
    y += (outline[a + 2] - outline[b + 2]) * (outline[a] + outline[b] - twoX);
    z += (outline[a] - outline[b]) * (outline[a + 1] + outline[b + 1] - twoY);
  }
  return [x, y, z];
}

/** Splits at corner 0, as viewers do, unless the quad is concave at corner 1 or 3. */
function splitQuad(q: ArrayLike<number>): readonly number[] {
  const n = newellNormal(q, 4);
  if (isTurnedAs(n, q, 0, 1, 2) && isTurnedAs(n, q, 0, 2, 3)) return FROM_ZERO;
  return isTurnedAs(n, q, 0, 1, 3) && isTurnedAs(n, q, 1, 2, 3) ? FROM_ONE : FROM_ZERO;
}

/** Whether the triangle of three corners faces along n; allocates nothing. */
function isTurnedAs(n: Vec3, outline: ArrayLike<number>, i: number, j: number, k: number): boolean {
  const x = outline[3 * i];
  const y = outline[3 * i + 1];
  const z = outline[3 * i + 2];
  const ux = outline[3 * j] - x;
  const uy = outline[3 * j + 1] - y;
  const uz = outline[3 * j + 2] - z;
  const vx = outline[3 * k] - x;
  const vy = outline[3 * k + 1] - y;
  const vz = outline[3 * k + 2] - z;
  return (uy * vz - uz * vy) * n[0] + (uz * vx - ux * vz) * n[1] + (ux * vy - uy * vx) * n[2] > 0;
}

function projected(outline: ArrayLike<number>, count: number, normal: Vec3): number[] {
  const n = normalize(normal, [0, 0, 1]);
  const away: Vec3 = Math.abs(n[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0];
  const e1 = normalize(cross(away, n));
  const e2 = cross(n, e1);
  const o = pointAt(outline, 0);
  return Array.from({ length: count }, (_, k) => sub(pointAt(outline, k), o)).flatMap((d) => [dot(d, e1), dot(d, e2)]);
}

/**
 * Earcut returns clockwise or counter-clockwise triples and drops corners on straight parts of the outline. This restores the winding of the outline and splits
 * the triangle at the edge of each dropped run so that it uses these corners.
 */
function withDroppedCorners(triangles: readonly number[], corners: number): number[] | undefined {
  if (triangles.length === 0) return undefined;
  const used = new Set(triangles);
  const runs = droppedRuns(used, corners);
  const out: number[] = [];
  for (let i = 0; i < triangles.length; i += 3) {
    out.push(...withRuns(oriented(triangles[i], triangles[i + 1], triangles[i + 2]), runs, corners));
  }
  return out.length === 3 * (corners - 2) ? out : undefined;
}

/** Corner → the next used corner, where corners between the two were dropped. */
function droppedRuns(used: ReadonlySet<number>, corners: number): Map<number, number> {
  const runs = new Map<number, number>();
  for (const from of used) {
    let to = (from + 1) % corners;
    while (!used.has(to)) to = (to + 1) % corners;
    if (to !== (from + 1) % corners) runs.set(from, to);
  }
  return runs;
}

/** Any triangle of a simple polygon visits its corners in the outline's cyclic order. */
function oriented(a: number, b: number, c: number): readonly [number, number, number] {
  const turns = (a < b ? 1 : 0) + (b < c ? 1 : 0) + (c < a ? 1 : 0);
  return turns === 2 ? [a, b, c] : [a, c, b];
}

/** Triangulates the triangle's outline with the dropped corners of its sides restored. */
function withRuns(t: readonly [number, number, number], runs: ReadonlyMap<number, number>, corners: number): number[] {
  const sides = [0, 1, 2].map((k) => {
    const from = t[k];
    const to = t[(k + 1) % 3];
    const side = [from];
    if (runs.get(from) === to) for (let d = (from + 1) % corners; d !== to; d = (d + 1) % corners) side.push(d);
    return side;
  });
  const first = sides.findIndex((side) => side.length > 1);
  if (first < 0) return [...t];
  return cutSides(sides[first], sides[(first + 1) % 3], sides[(first + 2) % 3]);
}

/**
 * A triangle given by its three sides (each its first corner and the points on it, the first side with at least one),
 * cut so that no piece lies on one side: side 1 fans from the last point p of side 0, then side 2 from p, and what is
 * left of side 0 from the last point of side 2.
 */
function cutSides(side0: readonly number[], side1: readonly number[], side2: readonly number[]): number[] {
  const p = side0[side0.length - 1];
  const q = side2[side2.length - 1];
  return [...fanFrom(p, [...side1, side2[0]]), ...fanFrom(p, side2), ...fanFrom(q, side0)];
}

function fanFrom(apex: number, path: readonly number[]): number[] {
  return path.slice(1).flatMap((to, i) => [apex, path[i], to]);
}

function fan(corners: number): number[] {
  const out: number[] = [];
  for (let i = 1; i + 1 < corners; i++) out.push(0, i, i + 1);
  return out;
}
