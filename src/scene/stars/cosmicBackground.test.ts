import { expect, test } from 'vitest';
import { cosmicBackground, DAYLIGHT_LUMINANCE } from './cosmicBackground.ts';

const FULL = { dopplerMix: 1, beaming: 1 };
const luminance = ([r, g, b]: readonly number[]): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

// The Sun's luminance is 1.6e9 cd/m² below the atmosphere and 2.0e9 above (5772 K); platinum's freezing point, 2041 K, was the candela: 6.0e5 cd/m².
test('a blackbody has the luminance of textbooks', () => {
  const at = (T: number) => luminance(cosmicBackground(T / 2.7255, FULL));
  expect(at(2041.4) / 6e5).toBeCloseTo(1, 1);
  expect(at(5772) / 1.9e9).toBeCloseTo(1, 0);
  expect(at(6504) / DAYLIGHT_LUMINANCE).toBeCloseTo(1, 2);
});

test('the background is dark up to a D of a few hundred, then red, then white', () => {
  expect(luminance(cosmicBackground(1, FULL))).toBe(0);
  expect(luminance(cosmicBackground(100, FULL))).toBeLessThan(1e-9);
  const [red, , blue] = cosmicBackground(500, FULL);
  expect(red).toBeGreaterThan(4 * Math.max(blue, 0));
  const white = cosmicBackground(6504 / 2.7255, FULL);
  expect(white[0] / white[2]).toBeCloseTo(1, 1);
  expect(luminance(cosmicBackground(5000, { dopplerMix: 0, beaming: 1 }))).toBeCloseTo(0, 12);
});
