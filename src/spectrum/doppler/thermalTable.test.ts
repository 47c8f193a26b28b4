import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { deltaE2000, labOf } from '../../../tests/support/deltaE.ts';
import { anyBands, anyShift, judged, logarithmic, thermal } from '../../../tests/support/spectra.ts';
import { fromHalf } from '../../math/half.ts';
import { IDENTITY, invert, transform } from '../../math/mat3.ts';
import { dot, type Vec3 } from '../../math/vec3.ts';
import { colorOfSpectrum, LUMINANCE_WEIGHTS, observedColor, XYZ_TO_RENDER_SRGB } from '../color/observerColor.ts';
import { colorMatching } from '../observer/standardObserver.ts';
import { filterFromRgb, type SpectralFilter, WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { columnOf, tableColor, tableShape, tableTexel } from './dopplerTable.ts';
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

  test('is within 0.1 % of the luminance of white, and ΔE₀₀ within 0.5, of integration at every nanometre', () => {
    fc.assert(
      fc.property(anyBands, anyCase, (a, [T, Din, Dout]) => {
        const seen = seenAt(T, Din, Dout);
        fc.pre(seen >= 300);
        const [expected, got] = [exact(a, seen, Dout), fromTable(full, a, seen, Dout)];
        expect(Math.abs(dot(LUMINANCE_WEIGHTS, got) - dot(LUMINANCE_WEIGHTS, expected))).toBeLessThan(0.001);
        expect(deltaE2000(lab(got), lab(expected))).toBeLessThan(0.5);
      }),
      { numRuns: 400 },
    );
  });

  test('is so at extreme reflectances, where each band is 0 or 1', () => {
    const corner = fc.constantFrom(0, 1);
    const corners = fc.record({ rgb: fc.tuple(corner, corner, corner), uv: corner, ir: corner });
    fc.assert(
      fc.property(corners, logarithmic(300, 2e6), logarithmic(0.45, 2.2), (a, T, Dout) => {
        const [expected, got] = [exact(a, T, Dout), fromTable(full, a, T, Dout)];
        expect(Math.abs(dot(LUMINANCE_WEIGHTS, got) - dot(LUMINANCE_WEIGHTS, expected))).toBeLessThan(0.001);
        expect(deltaE2000(lab(got), lab(expected))).toBeLessThan(0.5);
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
      expect(tableShape(table, row)).toBe(0);
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
  const number = (row: number, k: number) => curve.values[4 * row + k];
  return [0, 1, 2, 3].map((k) => number(i, k) + (number(i + 1, k) - number(i, k)) * (place - i));
}

/** ∫ ȳ λ⁻⁵/(e^{c₂/λT} − 1) dλ by the constants of the SI, up to a constant. */
function planckLuminance(T: number): number {
  let sum = 0;
  for (let nm = 360; nm <= 830; nm++)
    sum += (colorMatching(nm * 1e-9)[1] * (nm / 555) ** -5) / Math.expm1(1.438_776_877_503_934e-2 / (nm * 1e-9 * T));
  return sum;
}

describe.each([
  ['table', (T: number) => tableShape(plain, rowOf(plain, T))],
  ['curve', (T: number) => curveAt(T)[3]],
])('the luminance of a blackbody by G of the %s', (_, shape) => {
  const luminance = (T: number) => blackbodyLuminance(shape(T), T);

  test('agrees with integration to 0.1 %, from 300 K, where it is e^−78 of daylight’s, to the limit of hot ones', () => {
    const [errors, temperatures] = [[] as number[], [] as number[]];
    for (let T = 300; T < 1e9; T *= 1.02) temperatures.push(T);
    for (const T of temperatures)
      errors.push(Math.abs(luminance(T) / (planckLuminance(T) / planckLuminance(6504)) - 1));
    expect(temperatures[errors.findIndex((error) => error > 0.001)]).toBeUndefined();
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
