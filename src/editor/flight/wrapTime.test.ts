import { expect, it } from 'vitest';
import { wrapTime } from './wrapTime.ts';

it('loops the timeline, or stops at its end', () => {
  expect(wrapTime(5.5, 1, 5, true)).toBeCloseTo(1.5, 12);
  expect(wrapTime(5.5, 1, 5, false)).toBe(5);
  expect(wrapTime(5.5, 0, 0, true)).toBe(5.5);
});
