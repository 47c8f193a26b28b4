import { describe, expect, it } from 'vitest';
import { pixelSequence } from './pixelSequence.ts';

/** The points of pair `k` in samples 0 … n − 1. */
function points(of: ReturnType<typeof pixelSequence>, k: number, n: number): (readonly [number, number])[] {
  return Array.from({ length: n }, (_, i) => {
    const random = of(i);
    for (let skipped = 0; skipped < 2 * k; skipped++) random();
    return [random(), random()] as const;
  });
}

describe('the sequence of a pixel', () => {
  it.each([0, 1, 2, 9])('has one point in each elementary box of area 1/16 (pair %i)', (k) => {
    const found = points(pixelSequence(7, 3, 5), k, 16);
    for (const columns of [1, 2, 4, 8, 16]) {
      const rows = 16 / columns;
      const boxes = found.map(([x, y]) => Math.floor(x * columns) * rows + Math.floor(y * rows));
      expect(new Set(boxes).size, `${columns} × ${rows}`).toBe(16);
    }
  });

  it('depends on seed and pixel, and on nothing else', () => {
    const first = (seed: number, x: number, y: number) => pixelSequence(seed, x, y)(0)();
    const all = [first(1, 2, 3), first(2, 2, 3), first(1, 3, 3), first(1, 2, 4), first(1, 3, 2)];
    expect(new Set(all).size).toBe(all.length);
    expect(first(1, 2, 3)).toBe(all[0]);
  });

  it('is uniform and uncorrelated over pixels: means of squares and products', () => {
    const n = 4000;
    const sums = [0, 0, 0];
    for (let p = 0; p < n; p++) {
      const random = pixelSequence(p, p % 61, p % 17)(p % 5);
      const [a, b, c] = [random(), random(), random()];
      sums[0] += a * a;
      sums[1] += a * b;
      sums[2] += b * c;
    }
    // The standard deviations of the means are 0.3, 0.22 and 0.22 divided by √n.
    for (const [k, mean] of [1 / 3, 1 / 4, 1 / 4].entries()) expect(Math.abs(sums[k] / n - mean)).toBeLessThan(0.02);
  });
});
