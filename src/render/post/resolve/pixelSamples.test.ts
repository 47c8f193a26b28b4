import { expect, it } from 'vitest';
import { gridPositions, haltonPosition, type SamplePosition } from './pixelSamples.ts';

/** Number of cells of an n × n grid that contain a position. */
const cells = (positions: readonly SamplePosition[], n: number): number =>
  new Set(positions.map(([x, y]) => `${Math.floor((x + 0.5) * n)} ${Math.floor((y + 0.5) * n)}`)).size;
const mean = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0) / values.length;

it.each([1, 2, 3, 5, 8])('a grid of n = %d has a position in each of its cells, and its mean is the centre', (n) => {
  const positions = gridPositions(n);
  expect(positions).toHaveLength(n * n);
  expect(cells(positions, n)).toBe(n * n);
  expect(mean(positions.map(([x]) => x))).toBeCloseTo(0);
  expect(mean(positions.map(([, y]) => y))).toBeCloseTo(0);
});

it('the first 4 and 16 positions of a grid form grids themselves', () => {
  const positions = gridPositions(8);
  expect(cells(positions.slice(0, 4), 2)).toBe(4);
  expect(cells(positions.slice(0, 16), 4)).toBe(16);
});

it('16 successive Halton positions cover the pixel, wherever one begins', () => {
  for (let first = 0; first < 16; first++) {
    const period = Array.from({ length: 16 }, (_, i) => haltonPosition(first + i));
    expect(Math.max(...period.flat().map(Math.abs))).toBeLessThanOrEqual(0.5);
    expect(cells(period, 3)).toBe(9);
  }
  expect(haltonPosition(16)).toEqual(haltonPosition(0));
});
