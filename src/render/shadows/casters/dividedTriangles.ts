import type { BatchArrays } from '../../geometry/batches.ts';

/** Longest edge of a part, as a fraction of the radius of its body. */
const LONGEST_EDGE = 1 / 16;
/** Largest number of parts of a batch; above it parts are larger. */
const MAX_PARTS = 2 ** 14;
/** Floats per vertex of a part: triangle, and the weights of its second and third corner. */
export const PART_FLOATS = 3;

/** A point of a triangle: the weights of its second and third corner, and where it is at rest [m]. */
type Point = readonly [second: number, third: number, x: number, y: number, z: number];

/**
 * Divides the triangles of a batch into parts, `PART_FLOATS` for each of their corners: an edge is halved until its pieces are short against the radius of
 * its body [m]. Both triangles of an edge halve it at the same points, so there are no gaps. Undefined if no edge is long: a mesh that is fine already.
 */
export function dividedTriangles(arrays: BatchArrays, radiusOf: (id: number) => number): Float32Array | undefined {
  for (let longest = LONGEST_EDGE; ; longest *= 2) {
    // A body that is a point has no parts.
    const parts = partsOf(arrays, (id) => longest * (radiusOf(id) || Number.POSITIVE_INFINITY));
    if (!parts) continue;
    return parts.length > 3 * PART_FLOATS * (arrays.indices.length / 3) ? Float32Array.from(parts) : undefined;
  }
}

/** Undefined if they are too many. */
function partsOf(
  { indices, positions, ids }: BatchArrays,
  longestOf: (id: number) => number,
): readonly number[] | undefined {
  const most = 3 * PART_FLOATS * Math.max(MAX_PARTS, indices.length / 3);
  const out: number[] = [];
  for (let i = 0; i < indices.length; i += 3) {
    const corner = (k: number, second: number, third: number): Point => {
      const at = 3 * indices[i + k];
      return [second, third, positions[at], positions[at + 1], positions[at + 2]];
    };
    const longest = longestOf(ids[2 * indices[i]] + 1);
    const divide = (a: Point, b: Point, c: Point): void => {
      const [ab, bc, ca] = [distance(a, b), distance(b, c), distance(c, a)];
      if (out.length > most) return;
      const size = Math.max(ab, bc, ca);
      // Edges that are not finite stay whole.
      if (!(size > longest && size < Number.POSITIVE_INFINITY)) {
        for (const [second, third] of [a, b, c]) out.push(i / 3, second, third);
        return;
      }
      const [p, q, apex] = ab >= bc && ab >= ca ? [a, b, c] : bc >= ca ? [b, c, a] : [c, a, b];
      const middle = p.map((x, k) => (x + q[k]) / 2) as readonly number[] as Point;
      divide(p, middle, apex);
      divide(middle, q, apex);
    };
    divide(corner(0, 0, 0), corner(1, 1, 0), corner(2, 0, 1));
  }
  return out.length > most ? undefined : out;
}

const distance = (a: Point, b: Point): number => Math.hypot(a[2] - b[2], a[3] - b[3], a[4] - b[4]);
