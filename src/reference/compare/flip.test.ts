import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import expected from './fixtures/flip.json' with { type: 'json' };
import { HEIGHT, pair, picture, WIDTH } from './fixtures/pairs.ts';
import { flip } from './flip.ts';
import { exposuresFor, hdrFlip } from './hdrFlip.ts';
import type { RgbImage } from './rgbImage.ts';
import { summarize } from './statistics.ts';

/** The authors' program computes in f32 and raises values near 0 to powers below 1. */
const TOLERANCE = 2e-4;

describe("against the authors' own program", () => {
  it.each(['noise', 'darker', 'shifted', 'firefly'] as const)('%s', (name) => {
    const map = flip(...pair(name));
    expect(Math.abs((summarize(map)?.mean ?? 1) - expected[name].mean)).toBeLessThan(TOLERANCE);
    for (const [x, y, value] of expected[name].pixels)
      expect(Math.abs(map[y * WIDTH + x] - value), `${x},${y}`).toBeLessThan(TOLERANCE);
  });

  it.each(['bright', 'night'] as const)('%s, high dynamic range', (name) => {
    const { map, exposures } = hdrFlip(...pair(name));
    const { start, stop, count } = expected[name].exposures;
    expect(exposures.count).toBe(count);
    // It rounds the luminance weights to four digits.
    expect(exposures.start).toBeCloseTo(start, 3);
    expect(exposures.stop).toBeCloseTo(stop, 3);
    expect(Math.abs((summarize(map)?.mean ?? 1) - expected[name].mean)).toBeLessThan(TOLERANCE);
    for (const [x, y, value] of expected[name].pixels)
      expect(Math.abs(map[y * WIDTH + x] - value), `${x},${y}`).toBeLessThan(TOLERANCE);
  });
});

describe('for every pair of pictures', () => {
  const size = { width: 9, height: 7 };
  const anyPicture = (most: number): fc.Arbitrary<RgbImage> =>
    fc
      .array(fc.float({ min: 0, max: most, noNaN: true }), { minLength: 189, maxLength: 189 })
      .map((values) => ({ ...size, rgb: Float32Array.from(values) }));

  it('is 0 between a picture and itself, within 0 … 1, and symmetric', () => {
    fc.assert(
      fc.property(anyPicture(1), anyPicture(1), (a, b) => {
        expect(flip(a, a).every((error) => error === 0)).toBe(true);
        const there = flip(a, b);
        expect(there.every((error) => error >= 0 && error <= 1)).toBe(true);
        expect(flip(b, a)).toEqual(there);
      }),
      { numRuns: 30 },
    );
  });

  it('HDR: is 0 between a picture and itself, and independent of the unit of light', () => {
    fc.assert(
      fc.property(anyPicture(100), anyPicture(100), fc.constantFrom(0.25, 4), (a, b, unit) => {
        const scaled = (p: RgbImage): RgbImage => ({ ...p, rgb: p.rgb.map((value) => unit * value) });
        // The exposures of a black reference come from the lower bound of luminance.
        fc.pre(exposuresFor(b).stop < 15);
        expect(hdrFlip(b, b).map.every((error) => error === 0)).toBe(true);
        const [before, after] = [hdrFlip(a, b).map, hdrFlip(scaled(a), scaled(b)).map];
        before.forEach((error, i) => void expect(after[i]).toBeCloseTo(error, 3));
      }),
      { numRuns: 15 },
    );
  });

  it('is nearly 1 between pure green and pure blue', () => {
    const [green, blue] = [1, 2].map((channel) => picture((_x, _y, k) => Number(k === channel), WIDTH, HEIGHT));
    expect(flip(green, blue)[0]).toBeCloseTo(1, 4);
  });
});
