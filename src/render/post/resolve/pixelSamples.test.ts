import { expect, it } from 'vitest';
import { gridPositions, haltonPosition, type SamplePosition } from './pixelSamples.ts';

/** Cells of an n × n grid that the places are in. */
const cells = (places: readonly SamplePosition[], n: number): number =>
  new Set(places.map(([x, y]) => `${Math.floor((x + 0.5) * n)} ${Math.floor((y + 0.5) * n)}`)).size;
const mean = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0) / values.length;

it.each([1, 2, 3, 5, 8])('a grid of %d × %d has a place in each of its cells, about the centre', (n) => {
  const places = gridPositions(n);
  expect(places).toHaveLength(n * n);
  expect(cells(places, n)).toBe(n * n);
  expect(mean(places.map(([x]) => x))).toBeCloseTo(0);
  expect(mean(places.map(([, y]) => y))).toBeCloseTo(0);
});

it('its beginnings are grids themselves', () => {
  const places = gridPositions(8);
  expect(cells(places.slice(0, 4), 2)).toBe(4);
  expect(cells(places.slice(0, 16), 4)).toBe(16);
});

it('wandering places come to all parts of a pixel, wherever one begins', () => {
  for (let first = 0; first < 16; first++) {
    const round = Array.from({ length: 16 }, (_, i) => haltonPosition(first + i));
    expect(Math.max(...round.flat().map(Math.abs))).toBeLessThanOrEqual(0.5);
    expect(cells(round, 3)).toBe(9);
  }
  expect(haltonPosition(16)).toEqual(haltonPosition(0));
});
