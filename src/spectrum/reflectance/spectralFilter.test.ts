import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { anyBands, judged, logarithmic } from '../../../tests/support/spectra.ts';
import { BASIS_ENDS, basisAt, filterFromRgb, reflectanceAt, WHITE_FILTER } from './spectralFilter.ts';

const anyWavelength = logarithmic(10e-9, 100e-6);

describe('the basis of Mallett and Yuksel', () => {
  test('agrees with colour-science within 1e-5, the accuracy of its sum', () => {
    judged.basis.forEach((expected, i) => {
      basisAt((380 + 20 * i) * 1e-9).forEach(
        (value, k) => void expect(Math.abs(value - expected[k])).toBeLessThan(1e-5),
      );
    });
  });

  test('has the sum 1 and is positive at every wavelength', () => {
    fc.assert(
      fc.property(anyWavelength, (wavelength) => {
        const basis = basisAt(wavelength);
        expect(basis[0] + basis[1] + basis[2]).toBeCloseTo(1, 12);
        expect(Math.min(...basis)).toBeGreaterThan(0);
      }),
    );
  });
});

describe('a filter', () => {
  test('is within 0 … 1', () => {
    fc.assert(
      fc.property(anyBands, anyWavelength, (bands, wavelength) => {
        const value = reflectanceAt(bands, wavelength);
        expect(value).toBeGreaterThanOrEqual(-1e-12);
        expect(value).toBeLessThanOrEqual(1 + 1e-12);
      }),
    );
    for (const wavelength of [1e-9, 450e-9, 1e-3]) expect(reflectanceAt(WHITE_FILTER, wavelength)).toBeCloseTo(1, 12);
  });

  test('has its `uv` and `ir` outside the visible, which default to the colour’s ends', () => {
    const own = filterFromRgb([0.1, 0.5, 0.2], 0.9, 0.7);
    expect([300e-9, 359e-9].map((wavelength) => reflectanceAt(own, wavelength))).toEqual([0.9, 0.9]);
    expect([831e-9, 10e-6].map((wavelength) => reflectanceAt(own, wavelength))).toEqual([0.7, 0.7]);
    const plain = filterFromRgb([0.1, 0.5, 0.2]);
    expect(reflectanceAt(plain, 1e-6)).toBeCloseTo(reflectanceAt(plain, 780e-9), 12);
    expect(reflectanceAt(plain, 100e-9)).toBeCloseTo(reflectanceAt(plain, 380e-9), 12);
    for (const end of [BASIS_ENDS.uv, BASIS_ENDS.ir]) expect(end[0] + end[1] + end[2]).toBeCloseTo(1, 12);
  });

  test('changes over a step of finite width', () => {
    const ultraviolet = filterFromRgb([0, 0, 0], 1, 0);
    expect(reflectanceAt(ultraviolet, 359.5e-9, 1e-9)).toBeCloseTo(0.5, 6);
    expect(reflectanceAt(ultraviolet, 359.75e-9, 1e-9)).toBeCloseTo(0.25, 6);
    expect(reflectanceAt(ultraviolet, 361e-9, 1e-9)).toBe(0);
  });
});
