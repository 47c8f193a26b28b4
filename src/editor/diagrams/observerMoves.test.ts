import { expect, it } from 'vitest';
import { alongAxis, betaAlong, keptAxis, movedBy } from './observerMoves.ts';

it('moves the observer by a separation of the world', () => {
  const moved = movedBy({ t: 3, position: [1, 0, 0] }, { ct: 20, x: [4, 0, -2] }, -0.5, 10);
  expect(moved).toEqual({ t: 2, position: [-1, 0, 1] });
});

it('gives velocities along the axis, below that of light', () => {
  expect(alongAxis([0, 0, -1], 0.6)[2]).toBeCloseTo(-0.75, 12);
  expect(betaAlong([0, 0, -1], alongAxis([0, 0, -1], -0.3))).toBeCloseTo(-0.3, 12);
  expect(betaAlong([1, 0, 0], alongAxis([1, 0, 0], 5))).toBeCloseTo(0.99, 12);
});

it('keeps the sense of the axis when the observer turns back, and at rest', () => {
  expect(keptAxis(undefined, [0, 0, 0])).toBeUndefined();
  expect(keptAxis(undefined, [0, 0, -2])).toEqual([0, 0, -1]);
  expect(keptAxis([0, 0, -1], [0, 0, 3])).toEqual([0, 0, -1]);
  expect(keptAxis([0, 0, -1], [0, 0, 0])).toEqual([0, 0, -1]);
  expect(keptAxis([0, 0, -1], [2, 0, 0])).toEqual([1, 0, 0]);
});
