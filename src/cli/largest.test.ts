import { expect, test } from 'vitest';
import { refuseLarger } from './largest.ts';

test('a picture that the GPU cannot draw is refused, whichever side is too long', () => {
  expect(() => refuseLarger({ width: 8192, height: 8192 }, 8192)).not.toThrow();
  expect(() => refuseLarger({ width: 8193, height: 9 }, 8192)).toThrow(/at most 8192 pixels .* not 8193 × 9/);
  expect(() => refuseLarger({ width: 9, height: 8193 }, 8192)).toThrow(/not 9 × 8193/);
});
