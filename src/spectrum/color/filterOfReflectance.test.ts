import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { deltaE2000, labOf } from '../../../tests/support/deltaE.ts';
import { logarithmic, thermal } from '../../../tests/support/spectra.ts';
import { invert, transform } from '../../math/mat3.ts';
import { addScaled, dot, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { colorMatching, WAVELENGTHS } from '../observer/standardObserver.ts';
import { type MeasuredReflectance, measuredReflectanceAt } from '../reflectance/measuredReflectance.ts';
import { filterFromRgb, reflectanceAt, WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { DAYLIGHT } from '../sources/lightSpectrum.ts';
import { logLuminance, logPlanck } from '../sources/planck.ts';
import { filterOfReflectance } from './filterOfReflectance.ts';
import {
  colorOfSpectrum,
  LUMINANCE_WEIGHTS,
  observedColor,
  toLinearSrgb,
  XYZ_TO_RENDER_SRGB,
} from './observerColor.ts';

const sampled = (at: (nanometres: number) => number): MeasuredReflectance => ({
  first: 300e-9,
  step: 5e-9,
  values: Array.from({ length: 221 }, (_, i) => at(300 + 5 * i)),
});
const rise = (x: number) => 1 / (1 + Math.exp(-x));
const bump = (nm: number, middle: number, width: number) => Math.exp(-(((nm - middle) / width) ** 2));
/** Like a leaf: green, dark in the red, bright from 720 nm on. */
const LEAF = sampled((nm) => 0.04 + 0.09 * bump(nm, 550, 35) + 0.44 * rise((nm - 715) / 12));
/** Like a paint: one edge. */
const RED = sampled((nm) => 0.05 + 0.75 * rise((nm - 600) / 10));
/** Like glass with a rare earth: a dark band where the eye is most sensitive. */
const DIDYMIUM = sampled((nm) => 0.85 - 0.75 * bump(nm, 585, 12) - 0.4 * bump(nm, 525, 10));

/** Independent sum over every nanometre: daylight shifted by D_in to a surface and by D_out to the observer, without D⁴. */
function integrated(reflectance: MeasuredReflectance, Din: number, Dout: number): Vec3 {
  const T = DAYLIGHT.temperature * Din * Dout;
  const level = Math.exp(logLuminance(T) - logLuminance(DAYLIGHT.temperature)) / (Din * Dout) ** 4;
  const xyz = WAVELENGTHS.reduce<Vec3>((sum, wavelength) => {
    const place = (Dout * wavelength - reflectance.first) / reflectance.step;
    const i = Math.min(Math.max(Math.floor(place), 0), reflectance.values.length - 2);
    const t = Math.min(Math.max(place - i, 0), 1);
    const share = (1 - t) * reflectance.values[i] + t * reflectance.values[i + 1];
    const radiance = Math.exp(logPlanck(wavelength, T) - logLuminance(T));
    return addScaled(sum, colorMatching(wavelength), 1e-9 * share * radiance);
  }, ZERO);
  return scale(toLinearSrgb(xyz), level);
}
const whiteSeen = (Din: number, Dout: number) => observedColor(WHITE_FILTER, WHITE_FILTER, DAYLIGHT, Din, Dout);

describe('a measured reflectance', () => {
  it.each([LEAF, RED, DIDYMIUM])('has the colour of its integral over every nanometre, at any shift', (reflectance) => {
    fc.assert(
      fc.property(logarithmic(1 / 4, 4), logarithmic(1 / 4, 4), (Din, Dout) => {
        const seen = observedColor(filterOfReflectance(reflectance), WHITE_FILTER, DAYLIGHT, Din, Dout);
        const exact = integrated(reflectance, Din, Dout);
        const level = Math.max(...whiteSeen(Din, Dout).map(Math.abs));
        for (let k = 0; k < 3; k++) expect(Math.abs(seen[k] - exact[k]) / level).toBeLessThan(2e-4);
      }),
      { numRuns: 20 },
    );
  });

  it('composed of bands has these bands', () => {
    const bands = filterFromRgb([0.7, 0.3, 0.1], 0.2, 0.6);
    const table: MeasuredReflectance = {
      first: 300e-9,
      step: 1e-9,
      values: Array.from({ length: 1200 }, (_, i) => reflectanceAt(bands, (300 + i) * 1e-9)),
    };
    const { rgb, uv, ir } = filterOfReflectance(table);
    [...rgb, uv, ir].forEach((value, k) => {
      expect(value).toBeCloseTo([...bands.rgb, bands.uv, bands.ir][k], 2);
    });
  });

  it('is extrapolated by its end values', () => {
    expect([1e-9, 299e-9, 1400e-9, 1e-3].map((wavelength) => measuredReflectanceAt(LEAF, wavelength))).toEqual(
      [0, 0, 220, 220].map((i) => LEAF.values[i]),
    );
  });

  it.each([
    ['leaf', LEAF, 52, 0.45],
    ['paint', RED, 52, 0.5],
    ['didymium', DIDYMIUM, 16, 0.15],
  ] as const)(
    'is represented by its bands exactly at rest, and within bounds from D = 1/2 to 2: %s',
    (_, reflectance, color, luminance) => {
      const XYZ = invert(XYZ_TO_RENDER_SRGB)!;
      const { rgb, uv, ir } = filterOfReflectance(reflectance);
      const errors = [0.5, 0.7, 0.9, 1, 1.1, 1.3, 1.5, 2].map((D) => {
        const white = scale(
          colorOfSpectrum(thermal(DAYLIGHT.temperature * D)),
          dot(LUMINANCE_WEIGHTS, whiteSeen(1, D)),
        );
        const [exact, shown] = [
          integrated(reflectance, 1, D),
          observedColor({ rgb, uv, ir }, WHITE_FILTER, DAYLIGHT, 1, D),
        ];
        const lab = (color: Vec3) => labOf(transform(XYZ, color), transform(XYZ, white));
        return {
          D,
          color: deltaE2000(lab(exact), lab(shown)),
          luminance:
            Math.abs(dot(LUMINANCE_WEIGHTS, exact) - dot(LUMINANCE_WEIGHTS, shown)) / dot(LUMINANCE_WEIGHTS, white),
        };
      });
      if (process.env.REPORT) console.table(errors);
      for (const error of errors) {
        expect(error.color).toBeLessThan(error.D === 1 ? 1e-6 : color);
        expect(error.luminance).toBeLessThan(error.D === 1 ? 1e-9 : luminance);
      }
    },
  );
});
