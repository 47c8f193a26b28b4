import fc from 'fast-check';
import { expect, test } from 'vitest';
import { pixelDifference } from './pixelDifference.ts';
import type { RgbImage } from './rgbImage.ts';
import { shareAbove, summarize } from './statistics.ts';

const size = { width: 5, height: 4 };
const anyPicture = fc
  .array(fc.float({ min: 0, max: 1, noNaN: true }), { minLength: 60, maxLength: 60 })
  .map((values): RgbImage => ({ ...size, rgb: Float32Array.from(values) }));
const gray = (value: number): RgbImage => ({ ...size, rgb: new Float32Array(60).fill(value) });

test('one value of sixty differs by ½', () => {
  const b = gray(0.25);
  b.rgb[31] = 0.75;
  const found = pixelDifference(gray(0.25), b, 1);
  expect([...found.map]).toEqual(Array.from({ length: 20 }, (_, i) => (i === 10 ? 0.5 : 0)));
  expect(found.max).toBe(0.5);
  expect(found.mean).toBeCloseTo(0.5 / 60, 12);
  expect(found.rmse).toBeCloseTo(0.5 / Math.sqrt(60), 12);
  expect(found.psnr).toBeCloseTo(10 * Math.log10(60 / 0.25), 10);
  expect(shareAbove(found.map, 0.4)).toBe(1 / 20);
  expect(shareAbove(found.map, 0.5)).toBe(0);
});

test('is 0 between a picture and itself, and symmetric', () => {
  fc.assert(
    fc.property(anyPicture, anyPicture, (a, b) => {
      expect(pixelDifference(a, a, 1)).toMatchObject({ mean: 0, max: 0, rmse: 0, psnr: Number.POSITIVE_INFINITY });
      const found = pixelDifference(a, b, 1);
      expect(pixelDifference(b, a, 1)).toEqual(found);
      expect(found.mean).toBeLessThanOrEqual(found.rmse + 1e-12);
      expect(found.rmse).toBeLessThanOrEqual(found.max + 1e-12);
    }),
  );
});

test('the 99th percentile of 101 errors is the hundredth', () => {
  const errors = Float32Array.from({ length: 101 }, (_, i) => (i * 37) % 101);
  expect(summarize(errors)).toEqual({ mean: 50, max: 100, p99: 99 });
  expect(summarize([])).toBeUndefined();
});
