import { expect, test } from 'vitest';
import { encodeDisplay } from './encodeDisplay.ts';

/** Linear light of the sRGB code value 118 (IEC 61966-2-1). */
const GREY = ((118 / 255 + 0.055) / 1.055) ** 2.4;

test('a uniform grey is its code value, dithered by at most half a step', () => {
  const pixels = encodeDisplay(new Float32Array(3 * 20 * 10).fill(GREY), 20, 10);
  expect(new Set(pixels)).toEqual(new Set([118, 255]));
});

test('between two code values the mean is preserved by dithering', () => {
  const between = ((118.25 / 255 + 0.055) / 1.055) ** 2.4;
  const pixels = encodeDisplay(new Float32Array(3 * 64 * 64).fill(between), 64, 64);
  const red = pixels.filter((_, i) => i % 4 === 0);
  expect(new Set(red)).toEqual(new Set([118, 119]));
  expect(red.reduce((sum, x) => sum + x, 0) / red.length).toBeCloseTo(118.25, 1);
});

test('black stays black, and values above 1 are white', () => {
  const [black, white] = [encodeDisplay(new Float32Array(3), 1, 1), encodeDisplay(new Float32Array(3).fill(2), 1, 1)];
  expect([...black, ...white]).toEqual([0, 0, 0, 255, 255, 255, 255, 255]);
});
