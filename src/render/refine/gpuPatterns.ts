import { BufferAttribute, BufferGeometry } from 'three/webgpu';
import { STEPS } from './gpuLeaf.ts';
import { MOST_LEVEL } from './leaf.ts';
import { PATTERNS } from './pattern.ts';

/** Where a level's triangles are in the indices of `allPatterns`. */
export interface IndexRun {
  readonly first: number;
  readonly count: number;
}

/** Triangles of a leaf by the level of its interior. */
export const patternTriangles = (level: number): number => 4 ** level;

/** Patterns one after another in one geometry: position = (i, j, level), i and j in pieces of the finest. */
export function patternGeometry(levels: readonly number[]): { geometry: BufferGeometry; runs: readonly IndexRun[] } {
  const places: number[] = [];
  const indices: number[] = [];
  const runs = levels.map((level) => {
    const pattern = PATTERNS[level];
    const [vertex, first] = [places.length / 3, indices.length];
    const step = STEPS >> level;
    for (let v = 0; v < pattern.places.length; v += 2)
      places.push(pattern.places[v] * step, pattern.places[v + 1] * step, level);
    for (const i of pattern.indices) indices.push(vertex + i);
    return { first, count: pattern.indices.length };
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(places), 3));
  geometry.setIndex(new BufferAttribute(Uint16Array.from(indices), 1));
  return { geometry, runs };
}

export const ALL_LEVELS: readonly number[] = Array.from({ length: MOST_LEVEL + 1 }, (_, level) => level);

const cut = new Map<number, Uint8Array>();

/**
 * The triangles of a leaf whose edges have these levels (packLevels), as six numbers each: (i, j) of the corners, in pieces of the finest
 * pattern. The same that a shader makes of the pattern of the highest level (gpuLeaf.ts), without those that shrink to nothing.
 */
export function cutPattern(levels: number): Uint8Array {
  const known = cut.get(levels) ?? makeCut([levels & 7, (levels >> 3) & 7, levels >> 6]);
  cut.set(levels, known);
  return known;
}

function makeCut(edges: readonly number[]): Uint8Array {
  const level = Math.max(...edges);
  const { places, indices } = PATTERNS[level];
  const out: number[] = [];
  for (let t = 0; t < indices.length; t += 3) {
    const corners = [0, 1, 2].map((k) => {
      const v = 2 * indices[t + k];
      return snapToEdges(places[v] * (STEPS >> level), places[v + 1] * (STEPS >> level), edges);
    });
    const [[ai, aj], [bi, bj], [ci, cj]] = corners;
    if ((bi - ai) * (cj - aj) !== (bj - aj) * (ci - ai)) out.push(...corners.flat());
  }
  return Uint8Array.from(out);
}

/** A place on an edge goes to one of the 2^level that the edge has, the nearest, or of two the one before. */
function snapToEdges(i: number, j: number, [l01, l12, l20]: readonly number[]): [number, number] {
  const snap = (k: number, level: number): number => {
    const step = STEPS >> level;
    return Math.floor((k + ((step - 1) >> 1)) / step) * step;
  };
  if (j === 0) return [snap(i, l01), 0];
  if (i + j === STEPS) return [STEPS - snap(j, l12), snap(j, l12)];
  if (i === 0) return [0, STEPS - snap(STEPS - j, l20)];
  return [i, j];
}
