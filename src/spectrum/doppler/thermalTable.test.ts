import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { deltaE2000, labOf } from '../../../tests/support/deltaE.ts';
import { anyBands, anyShift, judged, logarithmic, thermal } from '../../../tests/support/spectra.ts';
import { fromHalf } from '../../math/half.ts';
import { IDENTITY, invert, transform } from '../../math/mat3.ts';
import { dot, type Vec3 } from '../../math/vec3.ts';
import { colorOfSpectrum, LUMINANCE_WEIGHTS, observedColor, XYZ_TO_RENDER_SRGB } from '../color/observerColor.ts';
import { filterFromRgb, type SpectralFilter, WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { logLuminance } from '../sources/planck.ts';
import { columnOf, tableColor, tableTexel } from './dopplerTable.ts';
import { blackbodyCurve, blackbodyLuminance, rowOf, thermalTable } from './thermalTable.ts';

const plain = thermalTable(3);
const full = thermalTable(4);

const TO_XYZ = invert(XYZ_TO_RENDER_SRGB) ?? IDENTITY;
const lab = (rgb: Vec3) => labOf(transform(TO_XYZ, rgb), transform(TO_XYZ, [1, 1, 1]));
const fromTable = (table: typeof full, a: SpectralFilter, T: number, Dout: number) =>
  tableColor(table, rowOf(table, T), columnOf(table, Dout), a);
const exact = (a: SpectralFilter, T: number, Dout: number) =>
  observedColor(a, WHITE_FILTER, thermal(T), 1 / Dout, Dout);

test('ΔE₀₀ agrees with colour-science', () => {
  for (const [a, b, expected] of judged.differences) expect(deltaE2000(a, b)).toBeCloseTo(expected, 5);
});

describe('the table of blackbodies', () => {
  /** T at rest, D_in, D_out. */
  const anyCase = fc.tuple(logarithmic(1000, 40_000), anyShift, anyShift);
  const seenAt = (T: number, Din: number, Dout: number) => T * Din * Dout;

  test('is within 0.2 % of the luminance of white, and ΔE₀₀ within 1, of integration at every nanometre', () => {
    fc.assert(
      fc.property(anyBands, anyCase, (a, [T, Din, Dout]) => {
        const seen = seenAt(T, Din, Dout);
        fc.pre(seen >= 500);
        const [expected, got] = [exact(a, seen, Dout), fromTable(full, a, seen, Dout)];
        expect(Math.abs(dot(LUMINANCE_WEIGHTS, got) - dot(LUMINANCE_WEIGHTS, expected))).toBeLessThan(0.002);
        expect(deltaE2000(lab(got), lab(expected))).toBeLessThan(1);
      }),
      { numRuns: 400 },
    );
  });

  test('is so at extreme reflectances, where each band is 0 or 1', () => {
    const corner = fc.constantFrom(0, 1);
    const corners = fc.record({ rgb: fc.tuple(corner, corner, corner), uv: corner, ir: corner });
    fc.assert(
      fc.property(corners, logarithmic(500, 2e6), logarithmic(0.45, 2.2), (a, T, Dout) => {
        const [expected, got] = [exact(a, T, Dout), fromTable(full, a, T, Dout)];
        expect(Math.abs(dot(LUMINANCE_WEIGHTS, got) - dot(LUMINANCE_WEIGHTS, expected))).toBeLessThan(0.002);
        expect(deltaE2000(lab(got), lab(expected))).toBeLessThan(1);
      }),
      { numRuns: 400 },
    );
  });

  test('with three layers gives the same for filters without uv and ir', () => {
    fc.assert(
      fc.property(anyBands, logarithmic(500, 1e6), anyShift, ({ rgb }, T, Dout) => {
        const a = filterFromRgb(rgb);
        expect(deltaE2000(lab(fromTable(plain, a, T, Dout)), lab(exact(a, T, Dout)))).toBeLessThan(1);
      }),
      { numRuns: 200 },
    );
  });

  test('agrees with tables of colour-science', () => {
    for (const { a, T, Din, Dout, neutral } of judged.seen) {
      const [r, g, b, uv, ir] = a;
      const seen = seenAt(T, Din, Dout);
      if (seen < 500) continue;
      expect(deltaE2000(lab(fromTable(full, { rgb: [r, g, b], uv, ir }, seen, Dout)), lab(neutral))).toBeLessThan(1);
    }
  });

  test('is the identity in daylight at rest, to the last bit', () => {
    for (const table of [plain, full]) {
      const [row, column] = [rowOf(table, 6504), columnOf(table, 1)];
      expect([Number.isInteger(row), Number.isInteger(column)]).toEqual([true, true]);
      const columns = [0, 1, 2].map((layer) => tableTexel(table, layer, row, column));
      columns.forEach((texel, layer) => {
        for (let k = 0; k < 3; k++) expect(texel[k] === (k === layer ? 1 : 0)).toBe(true);
      });
      expect(columns[0][3]).toBe(1);
    }
  });

  test('is finite from 0 K to beyond 1e12 K and for any D', () => {
    expect(full.data.every((bits) => Number.isFinite(fromHalf(bits)))).toBe(true);
    for (const T of [0, 1, 1e12, Number.POSITIVE_INFINITY])
      for (const D of [0, 1e-300, 1, 1e300, Number.POSITIVE_INFINITY]) {
        const color = fromTable(full, { rgb: [0.2, 0.3, 0.4], uv: 0.5, ir: 0.25 }, T, D);
        expect(color.every(Number.isFinite)).toBe(true);
        // Only the ultraviolet is left at D → 0, only the infrared at D → ∞.
        const share = { 0: 0.5, 1e-300: 0.5, 1e300: 0.25, Infinity: 0.25 }[D];
        if (share) expect(dot(LUMINANCE_WEIGHTS, color)).toBeCloseTo(share, 3);
      }
  });
});

const curve = blackbodyCurve();
/** The curve's four numbers at T, interpolated. */
function curveAt(T: number): number[] {
  const place = rowOf(curve, T);
  const i = Math.min(Math.floor(place), curve.rows - 2);
  const number = (row: number, k: number) => fromHalf(curve.data[4 * row + k]);
  return [0, 1, 2, 3].map((k) => number(i, k) + (number(i + 1, k) - number(i, k)) * (place - i));
}

describe.each([
  ['table', (T: number) => tableTexel(plain, 0, rowOf(plain, T), 7.3)[3]],
  ['curve', (T: number) => curveAt(T)[3]],
])('the luminance of a blackbody by H of the %s', (_, shape) => {
  const luminance = (T: number) => blackbodyLuminance(shape(T), T);

  test('agrees with integration to 0.2 %', () => {
    fc.assert(
      fc.property(logarithmic(1000, 2.5e6), (T) => {
        const expected = Math.exp(logLuminance(T) - logLuminance(6504));
        expect(Math.abs(luminance(T) / expected - 1)).toBeLessThan(0.002);
      }),
    );
  });

  test('vanishes at low T, and grows as T at high T', () => {
    expect(luminance(100)).toBeLessThan(1e-60);
    expect(luminance(1e9) / luminance(1e7)).toBeCloseTo(100, 0);
  });
});

test('the curve of blackbodies has their colours at luminance 1', () => {
  fc.assert(
    fc.property(logarithmic(500, 1e7), (T) => {
      const [r, g, b] = curveAt(T);
      expect(deltaE2000(lab([r, g, b]), lab(colorOfSpectrum(thermal(T))))).toBeLessThan(0.5);
    }),
  );
});
