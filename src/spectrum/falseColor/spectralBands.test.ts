import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { colorMatching } from '../observer/standardObserver.ts';
import { colorRamp, valueAtPosition } from './falseColor.ts';
import { fitScale } from './falseColorScale.ts';
import { bandColor, bandOf, bandShares, REFERENCE_WAVELENGTH, SPECTRAL_BANDS } from './spectralBands.ts';

const shift = fc.double({ min: -8, max: 8, noNaN: true }).map(Math.exp);

describe('the fractions of the bands', () => {
  it('sum to 1, over adjacent bands only', () => {
    fc.assert(
      fc.property(shift, (D) => {
        const shares = bandShares(D);
        expect(shares.reduce((sum, share) => sum + share, 0)).toBeCloseTo(1, 12);
        expect(Math.min(...shares)).toBeGreaterThanOrEqual(0);
        const [first, last] = [shares.findIndex((share) => share > 0), shares.findLastIndex((share) => share > 0)];
        expect(last - first).toBeLessThanOrEqual(2);
      }),
    );
  });

  it('are the luminance of light emitted in each band', () => {
    // By sums over tenths of nanometres of the standard observer's curve at the observed wavelength.
    for (const D of [0.3, 0.62, 1, 1.42, 2.1, 5.4]) {
      const sums = SPECTRAL_BANDS.map(() => 0);
      for (let seen = 359.5e-9; seen < 830.5e-9; seen += 1e-10) {
        sums[SPECTRAL_BANDS.findIndex(({ name }) => name === bandOf(seen * D))]! += colorMatching(seen)[1];
      }
      const whole = sums.reduce((a, b) => a + b);
      bandShares(D).forEach((share, i) => {
        expect(Math.abs(share - sums[i]! / whole)).toBeLessThan(5e-4);
      });
    }
  });
});

describe('band colours', () => {
  it('are pure at rest and after large shifts', () => {
    const colorOf = (name: string) => SPECTRAL_BANDS.find((band) => band.name === name)!.color;
    expect(bandColor(1)).toEqual(colorOf('visible'));
    expect(bandColor(10)).toEqual(colorOf('thermal-infrared'));
    expect(bandColor(0.1)).toEqual(colorOf('far-ultraviolet'));
  });

  it('in a legend change at the ticks', () => {
    const scale = fitScale('band', []);
    const row = colorRamp('band', scale, 400);
    const near = (i: number) => {
      const wavelength = valueAtPosition('band', i / 399, scale);
      return SPECTRAL_BANDS.every(({ from }) => Math.abs(Math.log(wavelength / from)) > 0.35)
        ? bandOf(wavelength)
        : undefined;
    };
    let compared = 0;
    row.forEach((color, i) => {
      const name = near(i);
      if (!name) return;
      compared++;
      expect(color).toEqual(SPECTRAL_BANDS.find((band) => band.name === name)!.color);
    });
    expect(compared).toBeGreaterThan(150);
  });

  it('have names', () => {
    expect([300e-9, REFERENCE_WAVELENGTH, 1e-6, 1e-5, 1e-8].map(bandOf)).toEqual([
      'near-ultraviolet',
      'visible',
      'near-infrared',
      'thermal-infrared',
      'far-ultraviolet',
    ]);
  });
});
