import { describe, expect, it } from 'vitest';
import { MAX_LOG2_FACTOR, packFactors } from './patch.ts';
import { apexOf, baseFactorOf, EDGE_STEPS, PATTERNS, patternIndexOf, snapToEdge, tessellatePatch } from './pattern.ts';

type Levels = readonly [number, number, number];
const all = Array.from({ length: MAX_LOG2_FACTOR + 1 }, (_, log2Factor) => log2Factor);
const combinations: Levels[] = all.flatMap((a) => all.flatMap((b) => all.map((c): Levels => [a, b, c])));
const packedFactors = ([a, b, c]: Levels) => packFactors(a, b, c);

/** Corners of the patch's triangles, as (weight of corner 1, of corner 2) each. */
const trianglesOf = (factors: Levels): [number, number][][] => {
  const floats = tessellatePatch(packedFactors(factors));
  return Array.from({ length: floats.length / 6 }, (_, t) =>
    [0, 2, 4].map((k): [number, number] => [floats[6 * t + k], floats[6 * t + k + 1]]),
  );
};
const area = ([[ax, ay], [bx, by], [cx, cy]]: [number, number][]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);

describe('a patch tessellated by the factors of its edges', () => {
  it('is covered once: no triangle is flipped, and their areas add up to its own', () => {
    for (const factors of combinations) {
      const areas = trianglesOf(factors).map(area);
      expect(Math.min(...areas), `${factors}`).toBeGreaterThan(0);
      expect(
        areas.reduce((sum, a) => sum + a, 0),
        `${factors}`,
      ).toBeCloseTo(1, 6);
    }
  });

  it('has on each edge the places of its factor and no others', () => {
    for (const factors of combinations) {
      const points = trianglesOf(factors).flat();
      const edges = [
        points.filter(([, y]) => y === 0).map(([x]) => x),
        points.filter(([x, y]) => x + y === 1).map(([, y]) => y),
        points.filter(([x]) => x === 0).map(([, y]) => 1 - y),
      ];
      edges.forEach((places, edge) => {
        const expected = Array.from({ length: 2 ** factors[edge] + 1 }, (_, k) => k / 2 ** factors[edge]);
        expect(
          [...new Set(places)].sort((a, b) => a - b),
          `${factors}, edge ${edge}`,
        ).toEqual(expected);
      });
    }
  });

  it('with equal factors, no edge of a triangle is longer than a segment of its edges', () => {
    for (const log2Factor of all)
      for (const corners of trianglesOf([log2Factor, log2Factor, log2Factor]))
        corners.forEach(([x, y], k) => {
          const [p, q] = corners[(k + 1) % 3];
          const longest = Math.max(Math.abs(x - p), Math.abs(y - q), Math.abs(x + y - p - q));
          expect(longest).toBeCloseTo(2 ** -log2Factor, 12);
        });
  });

  it('is a strip if it is a sliver, and a lattice if its factors are equal', () => {
    expect(tessellatePatch(packFactors(4, 0, 4)).length / 6).toBeLessThan(48);
    expect(tessellatePatch(packFactors(4, 4, 4)).length / 6).toBe(256);
    expect(tessellatePatch(packFactors(0, 0, 0)).length / 6).toBe(1);
  });
});

it('there is a pattern for every pair of the largest and the base factor, with no more triangles than the lattice', () => {
  for (const log2Factor of all)
    for (let base = 0; base <= log2Factor; base++) {
      const pattern = PATTERNS[patternIndexOf(log2Factor, base)];
      expect(pattern.log2Factor).toBe(log2Factor);
      expect(pattern.indices.length / 3).toBeLessThanOrEqual(4 ** log2Factor);
    }
  expect(PATTERNS).toHaveLength(15);
});

it('a strip has more segments across than its base needs, so that errors across it do not add up', () => {
  expect(baseFactorOf([4, 0, 4])).toBe(1);
  expect(baseFactorOf([1, 4, 4])).toBe(2);
  expect(baseFactorOf([4, 3, 0])).toBe(2);
  for (const factors of combinations) {
    const base = baseFactorOf(factors);
    if (base < Math.max(...factors)) expect(base).toBeGreaterThan(Math.min(...factors));
  }
});

it('the apex is across from an edge with the lowest factor', () => {
  for (const factors of combinations) expect(factors[(apexOf(factors) + 1) % 3]).toBe(Math.min(...factors));
});

it('a place on an edge is snapped to one of the edge’s two nearest places', () => {
  for (const log2Factor of all)
    for (let k = 0; k <= EDGE_STEPS; k++) {
      const step = EDGE_STEPS >> log2Factor;
      for (let base = 0; base <= MAX_LOG2_FACTOR; base++) {
        expect(snapToEdge(k, log2Factor, base) % step).toBe(0);
        expect(Math.abs(snapToEdge(k, log2Factor, base) - k)).toBeLessThan(step);
      }
    }
});
