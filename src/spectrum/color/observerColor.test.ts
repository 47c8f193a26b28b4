import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { anyBands, anyShift, fromFive, judged, logarithmic, thermal } from '../../../tests/support/spectra.ts';
import { dot, type Vec3 } from '../../math/vec3.ts';
import { colorMatching, tristimulus } from '../observer/standardObserver.ts';
import { filterFromRgb, type SpectralFilter, WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { DAYLIGHT, type LineSpectrum, type SampledSpectrum } from '../sources/lightSpectrum.ts';
import { logLuminance } from '../sources/planck.ts';
import {
  colorOfSpectrum,
  LUMINANCE_WEIGHTS,
  observedColor,
  toLinearSrgb,
  XYZ_TO_RENDER_SRGB,
} from './observerColor.ts';

const close = (value: Vec3, expected: Vec3, digits = 9): void => {
  value.forEach((x, k) => void expect(x).toBeCloseTo(expected[k], digits));
};
const share = fc.double({ min: 0, max: 1, noNaN: true });
const rgb = fc.tuple(share, share, share);

/** Y(TD)/(Y(T) D⁴) */
const gain = (T: number, D: number) => Math.exp(logLuminance(T * D) - logLuminance(T)) / D ** 4;

describe('N', () => {
  test('agrees with tables of colour-science, and has the luminance of white', () => {
    judged.normaliser.flat().forEach((expected, i) => void expect(XYZ_TO_RENDER_SRGB[i]).toBeCloseTo(expected, 6));
    expect(LUMINANCE_WEIGHTS[0] + LUMINANCE_WEIGHTS[1] + LUMINANCE_WEIGHTS[2]).toBeCloseTo(1, 12);
    const xyz: Vec3 = [0.3, 0.5, 0.2];
    expect(dot(LUMINANCE_WEIGHTS, toLinearSrgb(xyz))).toBeCloseTo(0.5, 12);
  });
});

describe('the observed colour', () => {
  test.each(judged.seen.map((one, i) => ({ i, ...one })))('agrees with numpy’s integral, $i', (one) => {
    const { a, k, T, Din, Dout, rgb: expected, neutral } = one;
    const brightness = gain(T, Din * Dout);
    const relative = (filter: SpectralFilter) =>
      observedColor(fromFive(a), filter, thermal(T), Din, Dout).map((value) => value / brightness) as unknown as Vec3;
    close(relative(fromFive(k)), expected, 6);
    close(relative(WHITE_FILTER), neutral, 6);
  });

  test('of a surface colour in daylight at rest is that colour, whatever its uv and ir', () => {
    fc.assert(
      fc.property(anyBands, (a) => {
        close(observedColor(a, WHITE_FILTER, DAYLIGHT, 1, 1), a.rgb);
        close(observedColor(WHITE_FILTER, a, DAYLIGHT, 1, 1), a.rgb);
      }),
      { numRuns: 20 },
    );
  });

  test('of a blackbody at T shifted by D is a blackbody at T D, with D⁴ of its light left to beaming', () => {
    fc.assert(
      fc.property(logarithmic(500, 40_000), anyShift, anyShift, (T, Din, Dout) => {
        const D = Din * Dout;
        close(
          observedColor(WHITE_FILTER, WHITE_FILTER, thermal(T), Din, Dout),
          colorOfSpectrum(thermal(T * D)).map((x) => x * gain(T, D)) as unknown as Vec3,
        );
      }),
      { numRuns: 30 },
    );
  });

  test('is linear in the reflectance', () => {
    fc.assert(
      fc.property(anyBands, anyBands, anyShift, anyShift, (a, b, Din, Dout) => {
        const sum: SpectralFilter = {
          rgb: [a.rgb[0] + 2 * b.rgb[0], a.rgb[1] + 2 * b.rgb[1], a.rgb[2] + 2 * b.rgb[2]],
          uv: a.uv + 2 * b.uv,
          ir: a.ir + 2 * b.ir,
        };
        const [ofA, ofB] = [a, b].map((filter) => observedColor(filter, WHITE_FILTER, thermal(5000), Din, Dout));
        close(
          observedColor(sum, WHITE_FILTER, thermal(5000), Din, Dout),
          [0, 1, 2].map((k) => ofA[k] + 2 * ofB[k]) as unknown as Vec3,
        );
      }),
      { numRuns: 20 },
    );
  });

  test('of grey is grey along the whole Planckian locus', () => {
    fc.assert(
      fc.property(logarithmic(1000, 40_000), anyShift, (T, Dout) => {
        const [white, gray] = [1, 0.3].map((x) =>
          observedColor(filterFromRgb([x, x, x]), WHITE_FILTER, thermal(T), 1, Dout),
        );
        close(gray, white.map((value) => 0.3 * value) as unknown as Vec3);
      }),
      { numRuns: 20 },
    );
  });

  test('at extreme shifts depends on the ultraviolet or the infrared only', () => {
    fc.assert(
      fc.property(rgb, (color) => {
        const beyond = (Dout: number) =>
          observedColor(filterFromRgb(color, 0.25, 0.5), WHITE_FILTER, DAYLIGHT, 1 / Dout, Dout);
        close(beyond(0.43), [0.25, 0.25, 0.25]);
        close(beyond(2.32), [0.5, 0.5, 0.5]);
      }),
      { numRuns: 10 },
    );
  });

  test('of equal-energy light is white with D⁵/D⁴ times the luminance', () => {
    const flat: SampledSpectrum = { kind: 'sampled', first: 10e-9, step: 10e-6, values: [1, 1] };
    const white = toLinearSrgb(tristimulus(() => 1 / tristimulus(() => 1)[1]));
    for (const D of [0.5, 1, 3])
      close(
        observedColor(WHITE_FILTER, WHITE_FILTER, flat, Math.sqrt(D), Math.sqrt(D)),
        white.map((x) => x * D) as unknown as Vec3,
      );
  });

  test('hardly depends on the sampling step of a measured spectrum', () => {
    const values = [0, 1, 4, 9, 2, 7, 0];
    const coarse: SampledSpectrum = { kind: 'sampled', first: 420e-9, step: 20e-9, values };
    const at = (i: number) =>
      values[Math.floor(i / 8)] + ((values[Math.floor(i / 8) + 1] ?? 0) - values[Math.floor(i / 8)]) * ((i % 8) / 8);
    const fine: SampledSpectrum = { ...coarse, step: 2.5e-9, values: Array.from({ length: 49 }, (_, i) => at(i)) };
    for (const D of [0.8, 1, 1.7])
      close(
        observedColor(WHITE_FILTER, WHITE_FILTER, fine, 1, D),
        observedColor(WHITE_FILTER, WHITE_FILTER, coarse, 1, D),
        3,
      );
  });
});

describe('lines', () => {
  const sodium: LineSpectrum = { kind: 'lines', lines: [{ wavelength: 589e-9, weight: 3 }] };

  test('are seen at λ/D, in the colour of single wavelengths', () => {
    fc.assert(
      fc.property(anyShift, anyShift, (Din, Dout) => {
        const expected = colorMatching(589e-9 / (Din * Dout)).map((x) => x / colorMatching(589e-9)[1]);
        close(observedColor(WHITE_FILTER, WHITE_FILTER, sodium, Din, Dout), toLinearSrgb(expected as unknown as Vec3));
      }),
    );
  });

  test('meet a surface at λ/D_in, and their own filter at λ', () => {
    const [red, blue] = [filterFromRgb([1, 0, 0]), filterFromRgb([0, 0, 1])];
    const of = (a: SpectralFilter, k: SpectralFilter, Din: number) =>
      dot(LUMINANCE_WEIGHTS, observedColor(a, k, sodium, Din, 1 / Din));
    expect(of(red, WHITE_FILTER, 0.9)).toBeGreaterThan(0.85);
    expect(of(blue, WHITE_FILTER, 1.3)).toBeGreaterThan(0.85);
    for (const Din of [0.9, 1, 1.3]) expect(of(WHITE_FILTER, red, Din)).toBeCloseTo(of(WHITE_FILTER, red, 1), 9);
  });

  test('look like a narrow band at the same wavelength', () => {
    const lamp: SampledSpectrum = { kind: 'sampled', first: 588e-9, step: 1e-9, values: [0, 1, 0] };
    for (const D of [0.85, 1.2])
      close(
        observedColor(WHITE_FILTER, WHITE_FILTER, lamp, 1, D),
        observedColor(WHITE_FILTER, WHITE_FILTER, sodium, 1, D),
        2,
      );
  });
});
