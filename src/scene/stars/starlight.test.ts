import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { WHITE } from '../../spectrum/bands.ts';
import { seenColor } from '../../spectrum/observerColor.ts';
import { starlight } from './starlight.ts';

const FULL = { dopplerMix: 1, beaming: 1 };
const temperature = fc.double({ min: 1500, max: 40_000, noNaN: true });
const shift = fc.double({ min: 1 / 8, max: 8, noNaN: true });
const luminance = ([r, g, b]: readonly number[]): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

describe('starlight', () => {
  test('is what integration over all wavelengths gives, times D⁴', () => {
    fc.assert(
      fc.property(temperature, shift, (T, D) => {
        const exact = seenColor(WHITE, WHITE, { kind: 'thermal', temperature: T }, 1, D);
        const scale = luminance(exact) * D ** 4;
        starlight(T, D, FULL).forEach((value, k) => {
          expect(Math.abs(value - exact[k] * D ** 4)).toBeLessThan(0.006 * scale + 1e-9);
        });
      }),
      { numRuns: 200 },
    );
  });

  test('is the star’s own at rest, and wherever its motion is not to be seen', () => {
    for (const T of [3000, 5800, 20_000]) {
      expect(luminance(starlight(T, 1, FULL))).toBeCloseTo(1, 1);
      starlight(T, 7, { dopplerMix: 0, beaming: 0 }).forEach((value, k) => {
        expect(value).toBeCloseTo(starlight(T, 1, FULL)[k], 9);
      });
    }
  });

  test('stars ahead turn blue and bright, and behind they go out', () => {
    const [red, , blue] = starlight(4000, 3, FULL);
    expect(blue).toBeGreaterThan(red);
    expect(luminance(starlight(4000, 3, FULL))).toBeGreaterThan(81);
    expect(luminance(starlight(4000, 1 / 8, FULL))).toBeLessThan(1e-9);
    for (const D of [1e-6, 1e6])
      for (const value of starlight(4000, D, FULL)) expect(Number.isFinite(value)).toBe(true);
  });
});
