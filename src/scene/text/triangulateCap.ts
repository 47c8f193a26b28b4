import earcut from 'earcut';
import { type Point2, twiceArea } from './contours.ts';

/**
 * Triangulates the area between outlines: clockwise ones bound the filled area, others are holes. The triangles are counter-clockwise, and every side of an
 * outline is the side of one triangle: no corner lies inside another’s side, which would open as a crack where light bends lines.
 *
 * @param outlines corners in order
 * @returns triples of indices among all corners, in the order of the outlines
 */
export function triangulateCap(outlines: readonly (readonly Point2[])[]): number[] {
  const firsts = [0];
  for (const corners of outlines) firsts.push(firsts[firsts.length - 1] + corners.length);
  const all = outlines.flat();
  const islands = outlines.flatMap((corners, i) => (twiceArea(corners) < 0 ? [i] : []));
  const holesOf = new Map(islands.map((island): [number, number[]] => [island, []]));
  outlines.forEach((corners, i) => {
    if (twiceArea(corners) > 0) holesOf.get(smallestAround(corners[0], islands, outlines))?.push(i);
  });
  return islands.flatMap((island) => {
    const parts = [island, ...holesOf.get(island)!];
    const places = parts.flatMap((part) => outlines[part].map((_, i) => firsts[part] + i));
    const holes = parts.slice(1).map((_, i) => sum(parts.slice(0, i + 1).map((part) => outlines[part].length)));
    const cut = earcut(
      places.flatMap((place) => perturbed(all[place], place)),
      holes,
    );
    return withoutSlivers(
      cut.map((i) => places[i]),
      all,
    );
  });
}

const sum = (numbers: readonly number[]): number => numbers.reduce((a, b) => a + b, 0);

/** The innermost island that contains a point. */
function smallestAround(point: Point2, islands: readonly number[], outlines: readonly (readonly Point2[])[]): number {
  const around = islands.filter((island) => isInside(point, outlines[island]));
  const areas = around.map((island) => Math.abs(twiceArea(outlines[island])));
  return around[areas.indexOf(Math.min(...areas))] ?? -1;
}

/** Whether a ray to the right crosses the outline an odd number of times. */
function isInside([x, y]: Point2, corners: readonly Point2[]): boolean {
  let inside = false;
  corners.forEach(([ax, ay], i) => {
    const [bx, by] = corners[(i + 1) % corners.length];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  });
  return inside;
}

/** Perturbation of corners for triangulation [font units]; the shortest segments are ten times as long. */
const PERTURBATION = 1e-6;

/**
 * Earcut drops collinear corners. Perturbed by a different small amount each, none are collinear, so all are used; at
 * the true positions, triangles between them have zero area.
 */
const perturbed = ([x, y]: Point2, i: number): Point2 => [
  x + PERTURBATION * Math.cos(i * i),
  y + PERTURBATION * Math.sin(i * i),
];

/** Collinear runs are not much longer than this; each pass halves what is left of one. */
const PASSES = 16;
/** Relative to the longest side squared: smaller areas are rounding errors. */
const ROUNDING = 1e-9;

/** Flips the longest edge of each zero-area triangle, in place. */
function withoutSlivers(triangles: number[], all: readonly Point2[]): number[] {
  const sides = new Map<number, number>();
  const key = (a: number, b: number): number => a * all.length + b;
  const place = (t: number, corners: readonly number[]): void => {
    corners.forEach((corner, k) => {
      triangles[t + k] = corner;
      sides.set(key(corner, corners[(k + 1) % 3]), t);
    });
  };
  for (let t = 0; t < triangles.length; t += 3) place(t, triangles.slice(t, t + 3));
  let turned = true;
  for (let pass = 0; turned && pass < PASSES; pass++) {
    turned = false;
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, p] = longestFirst(triangles.slice(t, t + 3), all);
      const beyond = sides.get(key(b, a));
      if (beyond === undefined || !isSliver(all[a], all[b], all[p])) continue;
      const c = triangles.slice(beyond, beyond + 3).find((corner) => corner !== a && corner !== b)!;
      sides.delete(key(a, b));
      sides.delete(key(b, a));
      place(t, [a, c, p]);
      place(beyond, [c, b, p]);
      turned = true;
    }
  }
  return triangles;
}

const isSliver = (a: Point2, b: Point2, p: Point2): boolean =>
  Math.abs(twiceArea([a, b, p])) <= ROUNDING * distance(a, b) ** 2;
const distance = (a: Point2, b: Point2): number => Math.hypot(b[0] - a[0], b[1] - a[1]);

/** The triangle rotated so that its longest side is the first. */
function longestFirst(corners: readonly number[], all: readonly Point2[]): number[] {
  const lengths = corners.map((corner, k) => distance(all[corner], all[corners[(k + 1) % 3]]));
  const k = lengths.indexOf(Math.max(...lengths));
  return [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
}
