import { describe, expect, it } from 'vitest';
import { MAX_LOG2_FACTOR, packFactors } from './patch.ts';
import { apexOf, baseFactorOf, EDGE_STEPS, PATTERNS, patternIndexOf, snapToEdge, tessellatePatch } from './pattern.ts';

type Levels = readonly [number, number, number];
const all = Array.from({ length: MAX_LOG2_FACTOR + 1 }, (_, level) => level);
const combinations: Levels[] = all.flatMap((a) => all.flatMap((b) => all.map((c): Levels => [a, b, c])));
const packedFactors = ([a, b, c]: Levels) => packFactors(a, b, c);

/** Corners of the patch's triangles, as (weight of corner 1, of corner 2) each. */
const trianglesOf = (levels: Levels): [number, number][][] => {
  const floats = tessellatePatch(packedFactors(levels));
  return Array.from({ length: floats.length / 6 }, (_, t) =>
    [0, 2, 4].map((k): [number, number] => [floats[6 * t + k], floats[6 * t + k + 1]]),
  );
};
const area = ([[ax, ay], [bx, by], [cx, cy]]: [number, number][]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);

describe('a leaf that is cut as its edges ask', () => {
  it('is covered once: no piece is turned over, and together they are as large as it is', () => {
    for (const levels of combinations) {
      const areas = trianglesOf(levels).map(area);
      expect(Math.min(...areas), `${levels}`).toBeGreaterThan(0);
      expect(
        areas.reduce((sum, a) => sum + a, 0),
        `${levels}`,
      ).toBeCloseTo(1, 6);
    }
  });

  it('has on each edge the places of its level and no others', () => {
    for (const levels of combinations) {
      const points = trianglesOf(levels).flat();
      const edges = [
        points.filter(([, y]) => y === 0).map(([x]) => x),
        points.filter(([x, y]) => x + y === 1).map(([, y]) => y),
        points.filter(([x]) => x === 0).map(([, y]) => 1 - y),
      ];
      edges.forEach((places, edge) => {
        const expected = Array.from({ length: 2 ** levels[edge] + 1 }, (_, k) => k / 2 ** levels[edge]);
        expect(
          [...new Set(places)].sort((a, b) => a - b),
          `${levels}, edge ${edge}`,
        ).toEqual(expected);
      });
    }
  });

  it('where its edges are alike, no piece is longer than a piece of them', () => {
    for (const level of all)
      for (const corners of trianglesOf([level, level, level]))
        corners.forEach(([x, y], k) => {
          const [p, q] = corners[(k + 1) % 3];
          const most = Math.max(Math.abs(x - p), Math.abs(y - q), Math.abs(x + y - p - q));
          expect(most).toBeCloseTo(2 ** -level, 12);
        });
  });

  it('is one strip where it is a sliver, and a lattice where its edges are alike', () => {
    expect(tessellatePatch(packFactors(4, 0, 4)).length / 6).toBeLessThan(48);
    expect(tessellatePatch(packFactors(4, 4, 4)).length / 6).toBe(256);
    expect(tessellatePatch(packFactors(0, 0, 0)).length / 6).toBe(1);
  });
});

it('there is a pattern for every pair of the highest and the lowest level, with no more triangles than the lattice', () => {
  for (const level of all)
    for (let base = 0; base <= level; base++) {
      const pattern = PATTERNS[patternIndexOf(level, base)];
      expect(pattern.log2Factor).toBe(level);
      expect(pattern.indices.length / 3).toBeLessThanOrEqual(4 ** level);
    }
  expect(PATTERNS).toHaveLength(15);
});

it('a strip is cut finer across than its base asks, so that what lies across it does not add up', () => {
  expect(baseFactorOf([4, 0, 4])).toBe(1);
  expect(baseFactorOf([1, 4, 4])).toBe(2);
  expect(baseFactorOf([4, 3, 0])).toBe(2);
  for (const levels of combinations) {
    const base = baseFactorOf(levels);
    if (base < Math.max(...levels)) expect(base).toBeGreaterThan(Math.min(...levels));
  }
});

it('the apex is across from an edge of the lowest level', () => {
  for (const levels of combinations) expect(levels[(apexOf(levels) + 1) % 3]).toBe(Math.min(...levels));
});

it('a place on an edge goes to one of the two that the edge has next to it', () => {
  for (const level of all)
    for (let k = 0; k <= EDGE_STEPS; k++) {
      const step = EDGE_STEPS >> level;
      for (let base = 0; base <= MAX_LOG2_FACTOR; base++) {
        expect(snapToEdge(k, level, base) % step).toBe(0);
        expect(Math.abs(snapToEdge(k, level, base) - k)).toBeLessThan(step);
      }
    }
});
