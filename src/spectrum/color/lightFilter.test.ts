import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { logarithmic, thermal } from '../../../tests/support/spectra.ts';
import { dot, type Vec3 } from '../../math/vec3.ts';
import { WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { DAYLIGHT } from '../sources/lightSpectrum.ts';
import { blackbodyColor } from './blackbodyColor.ts';
import { lightFilter } from './lightFilter.ts';
import { colorOfSpectrum, LUMINANCE_WEIGHTS, observedColor } from './observerColor.ts';

const close = (value: Vec3, expected: Vec3, digits: number): void => {
  value.forEach((x, k) => void expect(x).toBeCloseTo(expected[k], digits));
};
const share = fc.double({ min: 0.3, max: 1, noNaN: true });
const pale = fc.tuple(share, share, share);

describe('the filter of a light', () => {
  test('in daylight is the colour', () => {
    fc.assert(
      fc.property(pale, (color) => close(lightFilter(color, DAYLIGHT).rgb, color, 9)),
      { numRuns: 20 },
    );
  });

  test('with any blackbody shows the colour on a white surface at rest', () => {
    fc.assert(
      fc.property(pale, logarithmic(2500, 40_000), (tint, T) => {
        const white = colorOfSpectrum(thermal(T));
        const color: Vec3 = [tint[0] * white[0], tint[1] * white[1], tint[2] * white[2]];
        close(observedColor(WHITE_FILTER, lightFilter(color, thermal(T)), thermal(T), 1, 1), color, 4);
      }),
      { numRuns: 20 },
    );
  });

  test('of a blackbody’s own colour is neutral, also without blue', () => {
    for (const T of [500, 1000, 1900, 6504, 1e5])
      close(lightFilter(colorOfSpectrum(thermal(T)), thermal(T)).rgb, [1, 1, 1], 9);
    // USD clips the negative blue of 1500 K; the filter may only add a little blue for that.
    expect(Math.max(...lightFilter(blackbodyColor(1500), thermal(1500)).rgb)).toBeLessThan(3);
  });

  test('of lines and measured lamps is only their brightness', () => {
    const lines = { kind: 'lines', lines: [{ wavelength: 589e-9, weight: 1 }] } as const;
    const k = lightFilter([0.9, 0.2, 0.4], lines);
    const luminance = dot(LUMINANCE_WEIGHTS, [0.9, 0.2, 0.4]);
    close(k.rgb, [luminance, luminance, luminance], 12);
    expect(dot(LUMINANCE_WEIGHTS, observedColor(WHITE_FILTER, k, lines, 1, 1))).toBeCloseTo(luminance, 9);
  });
});
