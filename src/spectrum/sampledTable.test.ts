import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { deltaE2000, labOf } from '../../tests/support/deltaE.ts';
import { anyBands, logarithmic } from '../../tests/support/spectra.ts';
import { IDENTITY, invert, transform } from '../math/mat3.ts';
import { dot, type Vec3 } from '../math/vec3.ts';
import { bandsOf, WHITE } from './bands.ts';
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

  test('is what integration says, over all shifts of its light and any reflectances', () => {
    fc.assert(
      fc.property(anyBands, logarithmic(0.4, 2.5), logarithmic(0.4, 2.5), (a, Din, Dout) => {
        const expected = seenColor(a, WHITE, spectrum, Din, Dout);
        const got = seen(Din * Dout, Dout, a);
        // Of the luminance at rest, which is 1.
        expect(Math.abs(dot(LUMINANCE, got) - dot(LUMINANCE, expected))).toBeLessThan(0.002);
        expect(deltaE2000(lab(got), lab(expected))).toBeLessThan(1);
      }),
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
