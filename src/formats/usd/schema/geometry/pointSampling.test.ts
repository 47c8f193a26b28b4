import { expect, it } from 'vitest';
import { fromPose } from '../../../../math/mat4.ts';
import { fromAxisAngle } from '../../../../math/quat.ts';
import { affordableTimes, boxCorners, transformedPoints } from './pointSampling.ts';

it('a mesh that needs too much memory keeps its first and last sample, and as many in between as fit', () => {
  const times = Float64Array.from({ length: 101 }, (_, i) => i);
  expect(affordableTimes(times, 240, 240 * 200)).toBe(times);
  expect(affordableTimes(times, 240, 240 * 5)).toEqual(Float64Array.of(0, 25, 50, 75, 100));
  expect(affordableTimes(times, 240, 0)).toEqual(Float64Array.of(0, 100));
});

it('the box around points has eight corners, and a single one without points', () => {
  expect(boxCorners([0, 0, 0, 1, 2, -3])).toHaveLength(8);
  expect(boxCorners([0, 0, 0, 1, 2, -3])[7]).toEqual([1, 2, 0]);
  expect(boxCorners([])).toEqual([[0, 0, 0]]);
  expect(boxCorners([0, Number.NaN, 0, 1, 2, Number.POSITIVE_INFINITY])[7]).toEqual([1, 2, 0]);
});

it('points are transformed by a quarter turn and a translation', () => {
  const matrix = fromPose({ position: [10, 20, 30], orientation: fromAxisAngle([0, 0, 1], Math.PI / 2) });
  const points = transformedPoints([1, 2, 3, 0, 0, 0], matrix);
  expect([...points].map((x) => Number(x.toFixed(12)))).toEqual([8, 21, 33, 10, 20, 30]);
});
