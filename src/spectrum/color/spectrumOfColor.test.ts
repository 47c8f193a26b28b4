import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { deltaE2000, labOf } from '../../../tests/support/deltaE.ts';
import { judged, logarithmic, thermal } from '../../../tests/support/spectra.ts';
import { invert, transform } from '../../math/mat3.ts';
import { dot, scale, type Vec3 } from '../../math/vec3.ts';
import { WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { DAYLIGHT } from '../sources/lightSpectrum.ts';
import { logLuminance } from '../sources/planck.ts';
import { blackbodyColor } from './blackbodyColor.ts';
import { lightFilter } from './lightFilter.ts';
import {
  colorOfSpectrum,
  LUMINANCE_WEIGHTS,
  observedColor,
  toLinearSrgb,
  XYZ_TO_RENDER_SRGB,
} from './observerColor.ts';
import { spectrumOfColor } from './spectrumOfColor.ts';

const XYZ = invert(XYZ_TO_RENDER_SRGB)!;
const ofLuminance1 = (color: Vec3): Vec3 => scale(color, 1 / dot(LUMINANCE_WEIGHTS, color));
const lab = (color: Vec3): Vec3 => labOf(transform(XYZ, ofLuminance1(color)), transform(XYZ, [1, 1, 1]));
/** Difference of colours at equal luminance. */
const apart = (a: Vec3, b: Vec3): number => deltaE2000(lab(a), lab(b));
/** Observed colour of a light of this colour at the shift D, without the D⁴ of beaming. */
const seen = (color: Vec3, D: number): Vec3 => {
  const spectrum = spectrumOfColor(color);
  return observedColor(WHITE_FILTER, lightFilter(color, spectrum), spectrum, 1, D);
};
const brightness = (T: number): number => Math.exp(logLuminance(T));

describe('the spectrum of a light given by its colour', () => {
  it('is a blackbody for a blackbody’s colour, and looks like one of T·D', () => {
    for (const T of [1700, 2400, 3200, 5000, 10_000, 20_000]) {
      const color = scale(colorOfSpectrum(thermal(T)), 7);
      expect(spectrumOfColor(color).temperature / T).toBeCloseTo(1, 3);
      for (const D of [0.5, 0.9, 1, 1.5, 2]) {
        // The luminance is that of Planck's law, too.
        const level = dot(LUMINANCE_WEIGHTS, seen(color, D)) / 7;
        expect(level / (brightness(T * D) / brightness(T) / D ** 4)).toBeCloseTo(1, 2);
        expect(apart(seen(color, D), colorOfSpectrum(thermal(T * D)))).toBeLessThan(0.5);
      }
    }
  });

  it('for the colour that files use for 3200 K looks like 1600 K at D = 1/2', () => {
    // USD's colours have D65 as white; the filter makes up the difference.
    expect(apart(seen(blackbodyColor(3200), 0.5), colorOfSpectrum(thermal(1600)))).toBeLessThan(2);
  });

  it('has the temperature computed by colour-science', () => {
    const within = judged.blackbodies.filter(([T]) => T >= 1600 && T <= 24_000);
    expect(within.length).toBeGreaterThan(2);
    for (const [T, [x, y]] of within) {
      const color = toLinearSrgb([x / y, 1, (1 - x - y) / y]);
      // Colours within one percent of daylight are 6504 K.
      expect(Math.abs(Math.log(spectrumOfColor(color).temperature / T))).toBeLessThan(
        Math.abs(T - 6504) < 140 ? 0.02 : 2e-3,
      );
    }
  });

  it('is daylight for white, and filtered daylight for red, green, blue and magenta', () => {
    const all: Vec3[] = [
      [1, 1, 1],
      [3, 3, 3],
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
      [1, 0, 1],
      [0, 1, 1],
    ];
    for (const color of all) expect(spectrumOfColor(color)).toBe(DAYLIGHT);
  });

  it('has the given colour at rest', () => {
    const share = fc.double({ min: 0.1, max: 1, noNaN: true });
    fc.assert(
      fc.property(fc.tuple(share, share, share), (color) => {
        expect(apart(seen(color, 1), color)).toBeLessThan(0.5);
      }),
      { numRuns: 40 },
    );
  });

  it('is continuous in the colour', () => {
    const share = fc.double({ min: 0, max: 1, noNaN: true });
    const step = 1e-4;
    fc.assert(
      fc.property(fc.tuple(share, share, share), fc.integer({ min: 0, max: 2 }), (color, k) => {
        const near: Vec3 = [color[0], color[1], color[2]].map((x, i) => (i === k ? x + step : x)) as unknown as Vec3;
        const level = color[0] + color[1] + color[2];
        const change = Math.log(spectrumOfColor(near).temperature / spectrumOfColor(color).temperature);
        expect(Math.abs(change) * (level + 1e-3)).toBeLessThan(100 * step);
      }),
      { numRuns: 2000 },
    );
  });

  it('has a temperature independent of brightness', () => {
    fc.assert(
      fc.property(logarithmic(1100, 24_000), logarithmic(1e-3, 1e3), (T, level) => {
        const color = colorOfSpectrum(thermal(T));
        const [a, b] = [color, scale(color, level)].map(spectrumOfColor);
        expect(b.temperature / a.temperature).toBeCloseTo(1, 9);
      }),
      { numRuns: 30 },
    );
  });
});
