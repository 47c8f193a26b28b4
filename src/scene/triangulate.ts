import earcut from 'earcut';
import { cross, dot, normalize, type Vec3 } from '../math/vec3.ts';

/**
 * Splits one polygon into triangles that keep its winding and use every corner of its outline, so that no neighbour
 * is left with a T-junction (which relativity would open into a crack). Concave and non-planar polygons are cut in
 * the plane of their Newell normal.
 *
 * @param outline corners in order [m]
 * @returns triples of places in `outline`
 */
export function triangulate(outline: readonly Vec3[]): number[] {
  if (outline.length < 3) return [];
  if (outline.length === 3) return [0, 1, 2];
  if (outline.length === 4) return splitQuad(outline);
  const flat = projected(outline, newellNormal(outline));
  return withDroppedCorners(earcut(flat), outline.length) ?? fan(outline.length);
}

/** Twice the polygon's vector area; its direction is the normal of a counter-clockwise outline (Newell's method). */
export function newellNormal(outline: readonly Vec3[]): Vec3 {
  const o = outline[0];
  let [x, y, z] = [0, 0, 0];
  for (let i = 0; i < outline.length; i++) {
    const a = outline[i];
    const b = outline[(i + 1) % outline.length];
    x += (a[1] - b[1]) * (a[2] + b[2] - 2 * o[2]);
    y += (a[2] - b[2]) * (a[0] + b[0] - 2 * o[0]);
    z += (a[0] - b[0]) * (a[1] + b[1] - 2 * o[1]);
  }
  return [x, y, z];
}

/** Along corner 0, as viewers do, unless the quad is concave at corner 1 or 3. */
function splitQuad(q: readonly Vec3[]): number[] {
  const n = newellNormal(q);
  const faces = (i: number, j: number, k: number) => dot(triangleNormal(q[i], q[j], q[k]), n) > 0;
  const alongZero = faces(0, 1, 2) && faces(0, 2, 3);
  const alongOne = faces(0, 1, 3) && faces(1, 2, 3);
  return alongZero || !alongOne ? [0, 1, 2, 0, 2, 3] : [0, 1, 3, 1, 2, 3];
}

const triangleNormal = (a: Vec3, b: Vec3, c: Vec3): Vec3 =>
  cross([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);

function projected(outline: readonly Vec3[], normal: Vec3): number[] {
  const n = normalize(normal, [0, 0, 1]);
  const away: Vec3 = Math.abs(n[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0];
  const e1 = normalize(cross(away, n));
  const e2 = cross(n, e1);
  const o = outline[0];
  return outline.flatMap((p) => {
    const d: Vec3 = [p[0] - o[0], p[1] - o[1], p[2] - o[2]];
    return [dot(d, e1), dot(d, e2)];
  });
}

/**
 * Earcut returns clockwise or counter-clockwise triples and leaves out corners on straight stretches of the outline.
 * Here the winding is made the outline's, and each left-out run is cut back into the triangle on its edge.
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

/** The triangle's outline with the dropped corners of its sides put back, cut into triangles. */
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
