import { MAX_LOG2_FACTOR } from './patch.ts';

/** Places in a pattern count in pieces of the finest one. */
export const EDGE_STEPS = 1 << MAX_LOG2_FACTOR;

/**
 * How a leaf is divided whose edges have at most n = 2^level pieces. The edge with the fewest is its base; rows run from the apex
 * across from it down to it, the i-th at the share i/n. A place (i, j) has i + j STEPS-ths of the way from the apex to the base, j of them along the edge
 * that ends at the base's second corner.
 *
 * In a lattice the i-th row has i pieces. In a strip, for slivers, it has 2^base at the base and half as many as often as it is half as long.
 */
export interface Pattern {
  readonly log2Factor: number;
  /** (i, j) per vertex. */
  readonly coordinates: Float32Array;
  readonly indices: Uint16Array;
}

/** `base` = level: a lattice. */
export const patternIndexOf = (level: number, base: number): number => (level * (level + 1)) / 2 + base;

/**
 * How wide a leaf is cut: what lies across a strip is the sum of a piece of its base and one of a long edge, and is off by more than either: up to (√a + √b)² where they are by a and b. So the base
 * has twice the pieces that it needs, and again twice where the two long edges do not go together; what is not much narrower than long is a lattice.
 */
export function baseFactorOf(levels: readonly [number, number, number]): number {
  const [least, middle, most] = [...levels].sort((a, b) => a - b);
  const base = least + 1 + most - middle;
  return base < most && base <= middle ? base : most;
}

export const PATTERNS: readonly Pattern[] = Array.from({ length: MAX_LOG2_FACTOR + 1 }, (_, level) =>
  Array.from({ length: level + 1 }, (_, base) => makePattern(level, base)),
).flat();

function makePattern(level: number, base: number): Pattern {
  const n = 1 << level;
  const places: number[] = [];
  const indices: number[] = [];
  let above = { first: 0, segments: 0 };
  for (let row = 0; row <= n; row++) {
    const here = { first: places.length / 2, segments: segmentsOfRow(row, level, base) };
    for (let k = 0; k <= here.segments; k++) {
      const j = here.segments > 0 ? (((EDGE_STEPS / n) * row) / here.segments) * k : 0;
      places.push((EDGE_STEPS / n) * row - j, j);
    }
    if (row > 0) triangulateStrip(above, here, indices);
    above = here;
  }
  return { log2Factor: level, coordinates: Float32Array.from(places), indices: Uint16Array.from(indices) };
}

function segmentsOfRow(row: number, level: number, base: number): number {
  if (base === level || row === 0) return row;
  const long = 1 << (level - base);
  return 1 << Math.max(0, Math.ceil(Math.log2(row / long)));
}

interface PatternRow {
  readonly first: number;
  readonly segments: number;
}

/** Triangles between two rows. */
function triangulateStrip(above: PatternRow, below: PatternRow, indices: number[]): void {
  let [a, b] = [0, 0];
  while (a < above.segments || b < below.segments) {
    const [top, bottom] = [above.first + a, below.first + b];
    if ((b + 1) * above.segments < (a + 1) * below.segments) {
      indices.push(top, bottom, bottom + 1);
      b++;
    } else {
      indices.push(top, bottom, top + 1);
      a++;
    }
  }
}

/**
 * A place at k STEPS-ths along an edge of some level goes to the nearest of the 2^level + 1 that the edge has, so that leaves on both sides of
 * the edge meet it at the same points; in the part of a strip that is one piece wide to the next one, else all triangles at the apex would lie
 * in the edge across from it. Each is taken by some vertex.
 */
export function snapToEdge(k: number, level: number, base: number): number {
  const step = EDGE_STEPS >> level;
  const single = k <= EDGE_STEPS >> base && step <= EDGE_STEPS >> base;
  return Math.floor((k + (single ? step - 1 : (step - 1) >> 1)) / step) * step;
}

/** Which corner of a leaf is the apex: across from the edge of the lowest level, the first of several. */
export function apexOf([l01, l12, l20]: readonly [number, number, number]): number {
  const lowest = Math.min(l01, l12, l20);
  return l01 === lowest ? 2 : l12 === lowest ? 0 : 1;
}

const tessellations = new Map<number, Float32Array>();

/**
 * The triangles of a leaf with such levels (packLevels): six numbers each, the weights of the leaf's corners 1 and 2 at its three vertices. The same that
 * a shader makes of the pattern (shaderPatch.ts), but for those that shrink to nothing.
 */
export function tessellatePatch(levels: number): Float32Array {
  const known = tessellations.get(levels) ?? makeTessellation([levels & 7, (levels >> 3) & 7, levels >> 6]);
  tessellations.set(levels, known);
  return known;
}

function makeTessellation(levels: readonly [number, number, number]): Float32Array {
  const [level, base] = [Math.max(...levels), baseFactorOf(levels)];
  const { coordinates: places, indices } = PATTERNS[patternIndexOf(level, base)];
  const apex = apexOf(levels);
  const turned = [0, 1, 2].map((e) => levels[(apex + e) % 3]);
  const out: number[] = [];
  for (let t = 0; t < indices.length; t += 3) {
    const corners = [0, 1, 2].map((k) => {
      const v = 2 * indices[t + k];
      const shares = snapCoordinates(places[v], places[v + 1], turned, { level, base });
      return [shares[(4 - apex) % 3], shares[(5 - apex) % 3]];
    });
    const [[ax, ay], [bx, by], [cx, cy]] = corners;
    if ((bx - ax) * (cy - ay) !== (by - ay) * (cx - ax)) out.push(...corners.flat());
  }
  return Float32Array.from(out);
}

/**
 * Weights of the apex and the base's ends; levels of the edges from the apex, of the base, and back to the apex. In a lattice, what is halfway goes to
 * the one before on the way round, so that no piece has all its corners on one edge.
 */
function snapCoordinates(
  i: number,
  j: number,
  [first, across, second]: readonly number[],
  { level, base }: { readonly level: number; readonly base: number },
): readonly [number, number, number] {
  let [c1, c2] = [i, j];
  if (j === 0) c1 = snapToEdge(i, first, base);
  else if (i === 0)
    c2 = base === level ? EDGE_STEPS - snapToEdge(EDGE_STEPS - j, second, base) : snapToEdge(j, second, base);
  else if (i + j === EDGE_STEPS) {
    c2 = snapToEdge(j, across, base);
    c1 = EDGE_STEPS - c2;
  }
  return [1 - (c1 + c2) / EDGE_STEPS, c1 / EDGE_STEPS, c2 / EDGE_STEPS];
}
