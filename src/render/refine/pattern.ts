import { MOST_LEVEL } from './leaf.ts';

/**
 * How the interior of a leaf of one level is divided: (n + 1)(n + 2)/2 vertices in rows along the edge 0–1 and n² triangles, n = 2^level.
 * The place of a vertex is (i, j)/n, its weights of the leaf's corners 1 and 2; corner 0 has what is left.
 */
export interface Pattern {
  readonly level: number;
  /** (i, j) per vertex. */
  readonly places: Uint8Array;
  readonly indices: Uint16Array;
}

function makePattern(level: number): Pattern {
  const n = 1 << level;
  const places: number[] = [];
  const indices: number[] = [];
  const first = (j: number) => j * (n + 1) - (j * (j - 1)) / 2;
  for (let j = 0; j <= n; j++) for (let i = 0; i + j <= n; i++) places.push(i, j);
  for (let j = 0; j < n; j++)
    for (let i = 0; i + j < n; i++) {
      const [a, b] = [first(j) + i, first(j + 1) + i];
      indices.push(a, a + 1, b);
      if (i + j + 1 < n) indices.push(a + 1, b + 1, b);
    }
  return { level, places: Uint8Array.from(places), indices: Uint16Array.from(indices) };
}

export const PATTERNS: readonly Pattern[] = Array.from({ length: MOST_LEVEL + 1 }, (_, level) => makePattern(level));

/**
 * A vertex at step k of n = 2^level along an edge whose own level is lower goes to the nearest of the edge's 2^edge + 1 places; in steps of n.
 * Every place is taken by some vertex, so leaves on both sides of the edge meet it at the same points, whatever their interiors.
 */
export function snapped(k: number, level: number, edge: number): number {
  const step = 1 << (level - edge);
  return Math.floor((k + (step >> 1)) / step) * step;
}
