import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { logarithmic, thermal } from '../../../tests/support/spectra.ts';
import { colorMatching, tristimulus } from '../observer/standardObserver.ts';
import { type LineSpectrum, linesOf, meanRadiance, type SampledSpectrum, spectralRadiance } from './lightSpectrum.ts';

const spiky: SampledSpectrum = { kind: 'sampled', first: 400e-9, step: 5e-9, values: [0, 0, 3, 0, 1, 1, 8, 0, 0, 2] };
const invisible: SampledSpectrum = { kind: 'sampled', first: 1e-6, step: 10e-9, values: [1, 2, 1] };

describe('S', () => {
  test('has the luminance 1', () => {
    const luminance = (spectrum: Parameters<typeof spectralRadiance>[0]) =>
      tristimulus((wavelength) => meanRadiance(spectrum, wavelength, 1e-9))[1];
    expect(luminance(spiky)).toBeCloseTo(1, 12);
    fc.assert(
      fc.property(logarithmic(10, 1e12), (T) => void expect(luminance(thermal(T))).toBeCloseTo(1, 9)),
      { numRuns: 30 },
    );
  });

  test('of an invisible light has the power of luminance 1 at 555 nm', () => {
    expect(meanRadiance(invisible, 1.01e-6, 40e-9) * 40e-9).toBeCloseTo(1, 9);
    const lines: LineSpectrum = { kind: 'lines', lines: [{ wavelength: 121.567e-9, weight: 7 }] };
    expect(linesOf(lines)).toEqual([{ wavelength: 121.567e-9, weight: 1 }]);
  });

  test('is linear between samples, and 0 outside of them', () => {
    const at = (nanometres: number) => spectralRadiance(spiky, nanometres * 1e-9);
    expect(at(412) / at(410)).toBeCloseTo(0.6, 9);
    expect([at(399), at(446)]).toEqual([0, 0]);
  });

  test('summed in steps of any width conserves the light', () => {
    fc.assert(
      fc.property(logarithmic(0.1e-9, 50e-9), logarithmic(1e-9, 50e-9), (width, offset) => {
        const steps = Math.ceil(200e-9 / width);
        let [sum, fine] = [0, 0];
        for (let i = 0; i < steps; i++) sum += meanRadiance(spiky, 320e-9 + offset + i * width, width) * width;
        for (const value of spiky.values) fine += value * 5e-9;
        const scale = spectralRadiance(spiky, 410e-9) / 3;
        // Half of the last sample's step lies outside the spectrum.
        expect(sum).toBeCloseTo((fine - 5e-9) * scale, 6);
      }),
      { numRuns: 40 },
    );
  });

  test('of zero samples is dark, and of a blackbody at 1 K finite', () => {
    const dark: SampledSpectrum = { ...spiky, values: [0, 0] };
    expect(spectralRadiance(dark, 402e-9)).toBe(0);
    for (const T of [1, 10, 1e12])
      for (const wavelength of [1e-9, 555e-9, 1])
        expect(Number.isFinite(spectralRadiance(thermal(T), wavelength))).toBe(true);
  });
});

test('lines have the luminance 1', () => {
  const lines = [589e-9, 400e-9, 700e-9].map((wavelength, i) => ({ wavelength, weight: i + 1 }));
  const scaled = linesOf({ kind: 'lines', lines });
  expect(scaled.reduce((sum, line) => sum + line.weight * colorMatching(line.wavelength)[1], 0)).toBeCloseTo(1, 12);
  expect(scaled[2].weight / scaled[0].weight).toBeCloseTo(3, 12);
});
