import { expect, it } from 'vitest';
import { FrameCap } from './frameCap.ts';

/** How many frames of a screen with that rate pass in ten seconds. */
function passed(screen: number, most: number): number {
  const cap = new FrameCap();
  return Array.from({ length: 10 * screen }, (_, i) => cap.passes((1000 * i) / screen, most)).filter(Boolean).length;
}

it.each([
  [60, 30, 300],
  [60, 60, 600],
  [120, 60, 600],
  [144, 30, 300],
  [24, 30, 240],
])('of %d frames a second at most %d pass', (screen, most, expected) => {
  expect(Math.abs(passed(screen, most) - expected)).toBeLessThanOrEqual(1);
});

it('a screen of 75 shows about 60, not every other frame', () => {
  expect(passed(75, 60)).toBeGreaterThan(550);
  expect(passed(75, 60)).toBeLessThanOrEqual(602);
});

it('the frames of a pause are not made up for', () => {
  const cap = new FrameCap();
  cap.passes(0, 30);
  const after = Array.from({ length: 60 }, (_, i) => cap.passes(5000 + (1000 * i) / 60, 30)).filter(Boolean).length;
  expect(after).toBeGreaterThanOrEqual(30);
  expect(after).toBeLessThanOrEqual(31);
});
