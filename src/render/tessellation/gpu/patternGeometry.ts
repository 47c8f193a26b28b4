import { BufferAttribute, BufferGeometry } from 'three/webgpu';
import { PATTERNS } from '../patches/pattern.ts';

/** Where a pattern's triangles are in the indices of a geometry with several patterns. */
export interface IndexRange {
  readonly first: number;
  readonly count: number;
}

/** Triangles of each patch that is drawn with a pattern. */
export const patternTriangleCount = (pattern: number): number => PATTERNS[pattern].indices.length / 3;

/** One geometry with several patterns in a row: position = (i, j, pattern). */
export function patternGeometry(patterns: readonly number[]): {
  geometry: BufferGeometry;
  runs: readonly IndexRange[];
} {
  const positions: number[] = [];
  const indices: number[] = [];
  const runs = patterns.map((pattern) => {
    const { coordinates, indices: patternIndices } = PATTERNS[pattern];
    const [vertex, first] = [positions.length / 3, indices.length];
    for (let v = 0; v < coordinates.length; v += 2) positions.push(coordinates[v], coordinates[v + 1], pattern);
    for (const i of patternIndices) indices.push(vertex + i);
    return { first, count: patternIndices.length };
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setIndex(new BufferAttribute(Uint16Array.from(indices), 1));
  return { geometry, runs };
}

export const ALL_PATTERNS: readonly number[] = PATTERNS.map((_, pattern) => pattern);
