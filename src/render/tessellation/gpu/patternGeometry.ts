import { BufferAttribute, BufferGeometry } from 'three/webgpu';
import { PATTERNS } from '../patches/pattern.ts';

/** Where a pattern's triangles are in the indices of a geometry of several. */
export interface IndexRange {
  readonly first: number;
  readonly count: number;
}

/** Of every leaf that is drawn with a pattern. */
export const patternTriangleCount = (pattern: number): number => PATTERNS[pattern].indices.length / 3;

/** Patterns one after another in one geometry: position = (i, j, which pattern). */
export function patternGeometry(which: readonly number[]): { geometry: BufferGeometry; runs: readonly IndexRange[] } {
  const positions: number[] = [];
  const indices: number[] = [];
  const runs = which.map((pattern) => {
    const { coordinates: places, indices: own } = PATTERNS[pattern];
    const [vertex, first] = [positions.length / 3, indices.length];
    for (let v = 0; v < places.length; v += 2) positions.push(places[v], places[v + 1], pattern);
    for (const i of own) indices.push(vertex + i);
    return { first, count: own.length };
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setIndex(new BufferAttribute(Uint16Array.from(indices), 1));
  return { geometry, runs };
}

export const ALL_PATTERNS: readonly number[] = PATTERNS.map((_, pattern) => pattern);
