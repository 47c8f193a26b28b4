import fc from 'fast-check';
import { expect, it } from 'vitest';
import { MatrixCache } from './matrixCache.ts';

/** A different matrix for each time. */
const matrixOf = (time: number): number[] => Array.from({ length: 16 }, (_, i) => time + i);

it('returns the matrix of the exact time, at any capacity', () => {
  const times = fc.array(fc.oneof(fc.double({ noNaN: true }), fc.integer({ min: -50, max: 50 })), { maxLength: 200 });
  fc.assert(
    fc.property(times, fc.integer({ min: 0, max: 40 }), (asked, expected) => {
      const memory = new MatrixCache(expected);
      for (const time of asked) expect(memory.getOrCompute(time, matrixOf)).toEqual(matrixOf(time));
    }),
  );
});

it('computes a matrix once if there is room', () => {
  const memory = new MatrixCache(100);
  const times = Array.from({ length: 100 }, (_, i) => i / 24);
  let made = 0;
  const make = (time: number): number[] => {
    made++;
    return matrixOf(time);
  };
  for (let again = 0; again < 10; again++) for (const time of times) memory.getOrCompute(time, make);
  // A few collide in the same slot.
  expect(made).toBeLessThan(250);
});
