import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { observedColor } from '../../spectrum/color/observerColor.ts';
import { WHITE_FILTER } from '../../spectrum/reflectance/spectralFilter.ts';
import { starlight } from './starlight.ts';

const FULL = { colors: 'spectral', dopplerMix: 1, beaming: 1 } as const;
const TINTED = { ...FULL, colors: 'approximate' } as const;
const temperature = fc.double({ min: 1500, max: 40_000, noNaN: true });
const shift = fc.double({ min: 1 / 8, max: 8, noNaN: true });
const luminance = ([r, g, b]: readonly number[]): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

describe('starlight', () => {
  test('equals the integral over all wavelengths, times D⁴', () => {
    fc.assert(
      fc.property(temperature, shift, (T, D) => {
        const exact = observedColor(WHITE_FILTER, WHITE_FILTER, { kind: 'thermal', temperature: T }, 1, D);
        const scale = luminance(exact) * D ** 4;
        starlight(T, D, FULL).forEach((value, k) => {
          expect(Math.abs(value - exact[k] * D ** 4)).toBeLessThan(0.006 * scale + 1e-9);
        });
      }),
      { numRuns: 200 },
    );
  });

  test('is the star’s own at rest, and where Doppler effects are off', () => {
    for (const T of [3000, 5800, 20_000]) {
      expect(luminance(starlight(T, 1, FULL))).toBeCloseTo(1, 1);
      starlight(T, 7, { ...FULL, dopplerMix: 0, beaming: 0 }).forEach((value, k) => {
        expect(value).toBeCloseTo(starlight(T, 1, FULL)[k], 9);
      });
    }
  });

  test('in approximate colours is the star’s own at rest, and tinted after a shift', () => {
    for (const T of [3000, 5800, 9000]) {
      const [exact, tinted] = [starlight(T, 1, FULL), starlight(T, 1, TINTED)];
      // Both are of luminance 1; spectra's white has the CIE's own curve, the tint's a fit.
      tinted.forEach((value, k) => {
        expect(Math.abs(value - exact[k])).toBeLessThan(0.03 * Math.max(...exact));
      });
    }
    // The tint is fitted to daylight; a red star's blue comes from a band with little light.
    const [r, g, b] = starlight(6504, 1.3, TINTED);
    expect(b).toBeGreaterThan(r);
    expect(luminance([r, g, b]) / luminance(starlight(6504, 1.3, FULL))).toBeCloseTo(1, 1);
    expect(luminance(starlight(3000, 2, TINTED))).toBeLessThan(0.5 * luminance(starlight(3000, 2, FULL)));
  });

  test('stars ahead become blue and bright, and those behind fade out', () => {
    const [red, , blue] = starlight(4000, 3, FULL);
    expect(blue).toBeGreaterThan(red);
    expect(luminance(starlight(4000, 3, FULL))).toBeGreaterThan(81);
    expect(luminance(starlight(4000, 1 / 8, FULL))).toBeLessThan(1e-9);
    for (const D of [1e-6, 1e6])
      for (const value of starlight(4000, D, FULL)) expect(Number.isFinite(value)).toBe(true);
  });
});
