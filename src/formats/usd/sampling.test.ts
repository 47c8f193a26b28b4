import { describe, expect, it } from 'vitest';
import { fromParts, type Mat4 } from '../../math/mat4.ts';
import { fromAxisAngle, toMatrix } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { affordableTimes, boxCorners, refineTimes } from './sampling.ts';

const turning =
  (turns: number) =>
  (t: number): Mat4 =>
    fromParts(toMatrix(fromAxisAngle([0, 0, 1], 2 * Math.PI * turns * t)), [0, 0, 0]);
const TIP: readonly Vec3[] = [[2, 0, 0]];

describe('times between samples', () => {
  it('are added until chords of a circle leave it by no more than the tolerance', () => {
    const { times, error } = refineTimes(Float64Array.of(0, 1), turning(1), TIP, 1e-3);
    expect(error).toBeLessThanOrEqual(1e-3);
    // A chord over the angle a leaves a circle of radius r by r(1 − cos a/2); the number of pieces is a power of two.
    const pieces = 2 ** Math.ceil(Math.log2(Math.PI / Math.acos(1 - 1e-3 / 2)));
    expect(times.length).toBe(pieces + 1);
  });

  it('are found where whole turns look like rest at both ends and in the middle', () => {
    for (const turns of [1, 2, 3, 4, 5, 10, 16]) {
      const { times } = refineTimes(Float64Array.of(0, 1), turning(turns), TIP, 1e-2);
      expect(times.length, `${turns}`).toBeGreaterThan(20 * turns);
    }
  });

  it('are not added to a straight way', () => {
    const sliding = (t: number): Mat4 => fromParts([1, 0, 0, 0, 1, 0, 0, 0, 1], [t, 2 * t, 0]);
    expect(refineTimes(Float64Array.of(0, 1, 3), sliding, TIP, 1e-9).times).toEqual(Float64Array.of(0, 1, 3));
  });

  it('say what is left where a jump cannot be followed', () => {
    const jump = (t: number): Mat4 => fromParts([1, 0, 0, 0, 1, 0, 0, 0, 1], [t < 0.4 ? 0 : 5, 0, 0]);
    const { times, error } = refineTimes(Float64Array.of(0, 1), jump, TIP, 1e-3);
    expect(error).toBeGreaterThan(1);
    expect(times.length).toBeLessThan(50);
  });
});

it('a mesh that would take too much memory keeps its first time, its last, and what fits between', () => {
  const times = Float64Array.from({ length: 101 }, (_, i) => i);
  expect(affordableTimes(times, 10, 240 * 200)).toBe(times);
  expect(affordableTimes(times, 10, 240 * 5)).toEqual(Float64Array.of(0, 25, 50, 75, 100));
  expect(affordableTimes(times, 10, 0)).toEqual(Float64Array.of(0, 100));
});

it('the box around points has eight corners, and one where there is nothing to measure', () => {
  expect(boxCorners([0, 0, 0, 1, 2, -3])).toHaveLength(8);
  expect(boxCorners([0, 0, 0, 1, 2, -3])[7]).toEqual([1, 2, 0]);
  expect(boxCorners([])).toEqual([[0, 0, 0]]);
});
