import { expect, test } from 'vitest';
import { judged } from '../../../tests/support/spectra.ts';
import { observedColor } from '../color/observerColor.ts';
import { WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { daylightSpectrum } from './daylight.ts';

test.each(judged.daylight)('daylight of %d K agrees with colour-science', (T, expected) => {
  const { values, first, step } = daylightSpectrum(T);
  expect([first, step, values.length]).toEqual([300e-9, 5e-9, 107].map((x) => expect.closeTo(x, 12)));
  values.forEach((value, i) => void expect(value).toBeCloseTo(Math.max(expected[i], 0), 5));
});

test('D65 is nearly as white as a blackbody of its temperature, slightly greener', () => {
  const [r, g, b] = observedColor(WHITE_FILTER, WHITE_FILTER, daylightSpectrum(6504), 1, 1);
  for (const value of [r, g, b]) expect(Math.abs(value - 1)).toBeLessThan(0.05);
  expect(g).toBeGreaterThan(r);
});

test('it ends with the CIE’s tables', () => {
  expect(daylightSpectrum(1000)).toEqual(daylightSpectrum(4000));
  expect(daylightSpectrum(1e5)).toEqual(daylightSpectrum(25_000));
});
