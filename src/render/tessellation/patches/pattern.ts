import { MAX_LOG2_FACTOR } from './patch.ts';

/** Coordinates in a pattern are counted in steps of the finest one. */
export const EDGE_STEPS = 1 << MAX_LOG2_FACTOR;

/**
 * How a patch is divided whose edges have at most n = 2^log2Factor segments. The edge with the fewest is its base; rows run from the apex, across from the base,
 * to the base, the i-th at the fraction i/n of the way. A place (i, j) is at (i + j)/EDGE_STEPS of the way from the apex to the base, j steps of it along the
 * edge that ends at the base's second corner.
 * In a lattice the i-th row has i segments. In a strip, for slivers, a row has 2^base segments at the base, and half as many each time that its length
 * halves.
 */
export interface Pattern {
  readonly log2Factor: number;
  /** (i, j) of each vertex. */
  readonly coordinates: Float32Array;
  readonly indices: Uint16Array;
}

/** `base` = `log2Factor` is a lattice. */
export const patternIndexOf = (log2Factor: number, base: number): number => (log2Factor * (log2Factor + 1)) / 2 + base;

/**
 * The log₂ of the number of segments at the base. A segment across a strip is the sum of one of its base and one of a long edge, and its error is larger than
 * either: up to (√a + √b)² for errors a and b. So the base gets twice the segments that it needs, and twice as many again for each step by which the two long
 * edges' factors differ; patches that are not much narrower than long get a lattice.
 */
export function baseFactorOf(factors: readonly [number, number, number]): number {
  const [minFactor, middle, maxFactor] = [...factors].sort((a, b) => a - b);
  const base = minFactor + 1 + maxFactor - middle;
  return base < maxFactor && base <= middle ? base : maxFactor;
}

export const PATTERNS: readonly Pattern[] = Array.from({ length: MAX_LOG2_FACTOR + 1 }, (_, log2Factor) =>
  Array.from({ length: log2Factor + 1 }, (_, base) => makePattern(log2Factor, base)),
).flat();

function makePattern(log2Factor: number, base: number): Pattern {
  const n = 1 << log2Factor;
  const coordinates: number[] = [];
  const indices: number[] = [];
  let above = { first: 0, segments: 0 };
  for (let row = 0; row <= n; row++) {
    const current = { first: coordinates.length / 2, segments: segmentsOfRow(row, log2Factor, base) };
    for (let k = 0; k <= current.segments; k++) {
      const j = current.segments > 0 ? (((EDGE_STEPS / n) * row) / current.segments) * k : 0;
      coordinates.push((EDGE_STEPS / n) * row - j, j);
    }
    if (row > 0) triangulateStrip(above, current, indices);
    above = current;
  }
  return { log2Factor, coordinates: Float32Array.from(coordinates), indices: Uint16Array.from(indices) };
}

function segmentsOfRow(row: number, log2Factor: number, base: number): number {
  if (base === log2Factor || row === 0) return row;
  const ratio = 1 << (log2Factor - base);
  return 1 << Math.max(0, Math.ceil(Math.log2(row / ratio)));
}

interface PatternRow {
  readonly first: number;
  readonly segments: number;
}

/** Triangulates the strip between two rows. */
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
 * Snaps a place at k/EDGE_STEPS along an edge to the nearest of the 2^log2Factor + 1 places that the edge has, so that patches on both sides of it meet at the
 * same points. Where a strip is one segment wide, it is snapped to the next one instead; otherwise all triangles at the apex would lie in the edge across
 * from it. Each place gets some vertex.
 */
export function snapToEdge(k: number, log2Factor: number, base: number): number {
  const step = EDGE_STEPS >> log2Factor;
  const isStrip = k <= EDGE_STEPS >> base && step <= EDGE_STEPS >> base;
  return Math.floor((k + (isStrip ? step - 1 : (step - 1) >> 1)) / step) * step;
}

/** Which corner of a patch is the apex: across from the edge with the lowest factor, the first of several. */
export function apexOf([l01, l12, l20]: readonly [number, number, number]): number {
  const lowest = Math.min(l01, l12, l20);
  return l01 === lowest ? 2 : l12 === lowest ? 0 : 1;
}

const tessellations = new Map<number, Float32Array>();

/**
 * The triangles of a patch with these factors (`packFactors`): six numbers each, the weights of the patch's corners 1 and 2 at the three vertices. These are
 * the triangles that a shader makes of the pattern (shaderPatch.ts), without the degenerate ones.
 */
export function tessellatePatch(factors: number): Float32Array {
  const cached = tessellations.get(factors) ?? makeTessellation([factors & 7, (factors >> 3) & 7, factors >> 6]);
  tessellations.set(factors, cached);
  return cached;
}

function makeTessellation(factors: readonly [number, number, number]): Float32Array {
  const [log2Factor, base] = [Math.max(...factors), baseFactorOf(factors)];
  const { coordinates, indices } = PATTERNS[patternIndexOf(log2Factor, base)];
  const apex = apexOf(factors);
  const fromApex = [0, 1, 2].map((e) => factors[(apex + e) % 3]);
  const out: number[] = [];
  for (let t = 0; t < indices.length; t += 3) {
    const corners = [0, 1, 2].map((k) => {
      const v = 2 * indices[t + k];
      const weights = snapCoordinates(coordinates[v], coordinates[v + 1], fromApex, { log2Factor, base });
      return [weights[(4 - apex) % 3], weights[(5 - apex) % 3]];
    });
    const [[ax, ay], [bx, by], [cx, cy]] = corners;
    if ((bx - ax) * (cy - ay) !== (by - ay) * (cx - ax)) out.push(...corners.flat());
  }
  return Float32Array.from(out);
}

/**
 * Weights of the apex and the base's ends, given the factors of the edges from the apex, of the base, and back to the apex. In a lattice, places halfway are
 * snapped backwards, in the sense of rotation, so that no triangle has all its corners on one edge.
 */
function snapCoordinates(
  i: number,
  j: number,
  [first, across, second]: readonly number[],
  { log2Factor, base }: { readonly log2Factor: number; readonly base: number },
): readonly [number, number, number] {
  let [c1, c2] = [i, j];
  if (j === 0) c1 = snapToEdge(i, first, base);
  else if (i === 0)
    c2 = base === log2Factor ? EDGE_STEPS - snapToEdge(EDGE_STEPS - j, second, base) : snapToEdge(j, second, base);
  else if (i + j === EDGE_STEPS) {
    c2 = snapToEdge(j, across, base);
    c1 = EDGE_STEPS - c2;
  }
  return [1 - (c1 + c2) / EDGE_STEPS, c1 / EDGE_STEPS, c2 / EDGE_STEPS];
}
