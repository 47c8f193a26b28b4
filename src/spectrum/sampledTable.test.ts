import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { deltaE2000, labOf } from '../../tests/support/deltaE.ts';
import { anyBands, logarithmic } from '../../tests/support/spectra.ts';
import { IDENTITY, invert, transform } from '../math/mat3.ts';
import { dot, type Vec3 } from '../math/vec3.ts';
import { type Bands, bandsOf, WHITE } from './bands.ts';
import { daylightSpectrum } from './daylight.ts';
import { columnOf, tableColor } from './dopplerTable.ts';
import { LIGHT_PRESETS } from './lightPresets.ts';
import type { SampledSpectrum } from './lightSpectrum.ts';
import { LUMINANCE, NORMALISER, seenColor } from './observerColor.ts';
import { sampledTable, shiftRowOf } from './sampledTable.ts';

const TO_XYZ = invert(NORMALISER) ?? IDENTITY;
const lab = (rgb: Vec3) => labOf(transform(TO_XYZ, rgb), transform(TO_XYZ, [1, 1, 1]));

const lamps = [...LIGHT_PRESETS].flatMap(([name, { spectrum }]) =>
  spectrum.kind === 'sampled' ? [[name, spectrum] as const] : [],
);

describe.each(lamps)('the table of %s', (_, spectrum) => {
  const table = sampledTable(spectrum, 4);
  const seen = (D: number, Dout: number, a = WHITE) =>
    tableColor(table, shiftRowOf(table, D), columnOf(table, Dout), a);

  /** The luminance of white at rest is 1. */
  const expectLike = (a: Bands, Din: number, Dout: number, tolerance: number) => {
    const [got, expected] = [seen(Din * Dout, Dout, a), seenColor(a, WHITE, spectrum, Din, Dout)];
    expect(Math.abs(dot(LUMINANCE, got) - dot(LUMINANCE, expected))).toBeLessThan(tolerance);
    expect(deltaE2000(lab(got), lab(expected))).toBeLessThan(1);
  };
  const shift = logarithmic(0.4, 2.5);

  test('is what integration says, for any colour: 0.35 % of the luminance, ΔE₀₀ < 1', () => {
    fc.assert(
      fc.property(anyBands, shift, shift, ({ rgb }, Din, Dout) => expectLike(bandsOf(rgb), Din, Dout, 0.0035)),
      { numRuns: 100 },
    );
  });

  test('is so for any ultraviolet and infrared to 1 %, where a narrow band of light crosses their beginning', () => {
    fc.assert(
      fc.property(anyBands, shift, shift, (a, Din, Dout) => expectLike(a, Din, Dout, 0.01)),
      { numRuns: 100 },
    );
  });

  test('has rest as a row, and is dark where the light has left sight', () => {
    expect(Number.isInteger(shiftRowOf(table, 1))).toBe(true);
    expect(dot(LUMINANCE, seen(1, 1))).toBeCloseTo(1, 3);
    for (const D of [0, 0.2, 5, Number.POSITIVE_INFINITY]) expect(seen(D, 1)).toEqual([0, 0, 0]);
  });
});

test('three layers are enough for filters that only have a colour', () => {
  const spectrum = daylightSpectrum(5000);
  const table = sampledTable(spectrum, 3);
  const a = bandsOf([0.8, 0.3, 0.1]);
  const got = tableColor(table, shiftRowOf(table, 0.8), columnOf(table, 1.4), a);
  expect(deltaE2000(lab(got), lab(seenColor(a, WHITE, spectrum, 0.8 / 1.4, 1.4)))).toBeLessThan(1);
});

test('a spectrum that reaches far has no more rows than a thousand', () => {
  const far: SampledSpectrum = { kind: 'sampled', first: 10e-9, step: 1e-6, values: [0, 1, 1, 1, 0] };
  expect(sampledTable(far, 3, 3).rows).toBeLessThanOrEqual(1024);
});
