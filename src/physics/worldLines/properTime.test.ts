import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { length, scale } from '../../math/vec3.ts';
import { properTimeBetween } from './properTime.ts';
import { velocityAt, type WorldLine } from './worldLine.ts';

const c = 10;
const cubic: WorldLine = {
  kind: 'cubic',
  times: Float64Array.of(0, 1, 2.5),
  positions: Float64Array.of(0, 0, 0, 4, 1, 0, 8, -2, 1),
  velocities: Float64Array.of(2, 0, 0, 6, -1, 0, 6, -1, 0, 1, -3, 2),
};
const polyline: WorldLine = {
  kind: 'polyline',
  times: Float64Array.of(0, 1, 2.5),
  positions: Float64Array.of(0, 0, 0, 8, 0, 0, 8, 9, 0),
};
const lines: readonly WorldLine[] = [
  { kind: 'static', position: [1, 2, 3] },
  { kind: 'uniform', position: [0, 0, 0], velocity: [3, 4, 6] },
  { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: [7, 0, -9], t0: 0.4 },
  { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: [0, 0, 0], t0: 0.4 },
  { kind: 'circular', center: [0, 0, 0], axis: [0, 0, 1], arm: [2, 0, 5], angularVelocity: 4 },
  polyline,
  cubic,
];

describe('proper time', () => {
  test('is ∫ √(1 − β²) dt, by the midpoint rule', () => {
    for (const line of lines) {
      const [from, to, n] = [-0.7, 3.3, 40_000];
      let sum = 0;
      for (let i = 0; i < n; i++) {
        const beta = length(scale(velocityAt(line, from + ((i + 0.5) * (to - from)) / n, c), 1 / c));
        sum += Math.sqrt(1 - beta * beta);
      }
      // Midpoints next to the corners of a polyline are right to a step.
      expect(properTimeBetween(line, from, to, c)).toBeCloseTo((sum * (to - from)) / n, line === polyline ? 4 : 8);
    }
  });

  test('adds up, and changes its sign with the direction', () => {
    const time = fc.double({ min: -5, max: 5, noNaN: true });
    fc.assert(
      fc.property(fc.constantFrom(...lines), time, time, time, (line, a, b, d) => {
        const sum = properTimeBetween(line, a, b, c) + properTimeBetween(line, b, d, c);
        // Gauss's rule on parts of a piece is another approximation than on the whole.
        expect(sum).toBeCloseTo(properTimeBetween(line, a, d, c), line.kind === 'cubic' ? 9 : 12);
        expect(properTimeBetween(line, b, a, c)).toBeCloseTo(-properTimeBetween(line, a, b, c), 12);
      }),
    );
  });

  test('of a trip at 1 g is (c/g) asinh(gt/c): 4.89 years in 75 of the world', () => {
    const year = 31_557_600;
    const line: WorldLine = { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: [9.80665, 0, 0], t0: 0 };
    expect(properTimeBetween(line, 0, 75 * year, 299_792_458) / year).toBeCloseTo(4.886, 2);
  });
});
