import { expect, test } from 'vitest';
import { dot } from '../../math/vec3.ts';
import { blackbodyColor, glowColor } from './blackbodyColor.ts';
import { colorOfSpectrum, LUMINANCE_WEIGHTS } from './observerColor.ts';

/** UsdLux.BlackbodyTemperatureAsRgb of usd-core 26.11. */
const USD: readonly (readonly [T: number, r: number, g: number, b: number])[] = [
  [1900, 2.6256, 0.6169, 0.008],
  [2500, 2.068, 0.7694, 0.1395],
  [3000, 1.771, 0.8443, 0.272],
  [6500, 1.0433, 0.9836, 1.0346],
  [10000, 0.8718, 0.9947, 1.43],
];

test.each(USD)('a blackbody of %d K has USD’s colour within half a percent', (T, ...rgb) => {
  blackbodyColor(T).forEach((value, k) => {
    expect(Math.abs(value - rgb[k]) / Math.max(...rgb)).toBeLessThan(0.0055);
  });
});

test('it is red, then white, then blue, of constant luminance, clamped at 10,000 K', () => {
  for (const T of [0, 1000, 2000, 6504, 1e5]) {
    const [r, g, b] = blackbodyColor(T);
    expect(0.2126 * r + 0.7152 * g + 0.0722 * b).toBeCloseTo(1, 12);
    expect(Math.min(r, g, b)).toBeGreaterThanOrEqual(0);
  }
  expect(blackbodyColor(1e5)).toEqual(blackbodyColor(1e4));
  expect(blackbodyColor(500)).toEqual(blackbodyColor(1000));
  blackbodyColor(6504).forEach((x) => void expect(Math.abs(x - 1)).toBeLessThan(0.05));
});

test('relative to its own daylight it has the colour of Planck’s law', () => {
  const day = blackbodyColor(6504);
  for (const temperature of [1900, 2500, 4000, 6504, 10_000]) {
    const white = colorOfSpectrum({ kind: 'thermal', temperature });
    blackbodyColor(temperature).forEach((value, k) => {
      expect(Math.abs(value / day[k] - white[k])).toBeLessThan(0.02 * Math.max(...white));
    });
  }
});

test('emission in approximate colours is the same relative to white daylight, of equal luminance', () => {
  for (const temperature of [700, 1900, 4000, 6504, 10_000]) {
    expect(dot(LUMINANCE_WEIGHTS, glowColor(temperature))).toBeCloseTo(1, 12);
  }
  glowColor(6504).forEach((value) => void expect(value).toBeCloseTo(1, 12));
});
