import { expect, test } from 'vitest';
import { decodeSrgb, encodeSrgb } from './srgb.ts';

test('sRGB encodes middle grey, 18 %, as 118 of 255, and its two parts are continuous', () => {
  expect(Math.round(255 * encodeSrgb(0.18))).toBe(118);
  expect(encodeSrgb(0.0031308)).toBeCloseTo(encodeSrgb(0.0031309), 5);
  [-1, 0, 1, 7].forEach((x, i) => void expect(encodeSrgb(x)).toBeCloseTo(i >> 1, 12));
});

test('decoding inverts encoding', () => {
  for (let byte = 0; byte < 256; byte++) expect(255 * encodeSrgb(decodeSrgb(byte / 255))).toBeCloseTo(byte, 4);
});
