import { expect, test } from 'vitest';
import { judged } from '../../../tests/support/spectra.ts';
import { transform } from '../../math/mat3.ts';
import { SRGB_TO_P3, SRGB_TO_XYZ, XYZ_TO_P3, XYZ_TO_SRGB } from './rgbSpaces.ts';

test.each([
  ['sRGB', XYZ_TO_SRGB, judged.srgb],
  ['Display P3', XYZ_TO_P3, judged.p3],
])('XYZ → linear %s agrees with colour-science', (_, matrix, expected) => {
  expected.flat().forEach((value, i) => void expect(matrix[i]).toBeCloseTo(value, 7));
});

test('white stays white, and sRGB’s red is inside of Display P3', () => {
  transform(SRGB_TO_P3, [1, 1, 1]).forEach((value) => void expect(value).toBeCloseTo(1, 12));
  for (const value of transform(SRGB_TO_P3, [1, 0, 0])) {
    expect(value).toBeGreaterThan(0);
    expect(value).toBeLessThan(1);
  }
  expect(transform(SRGB_TO_XYZ, [1, 1, 1])[1]).toBeCloseTo(1, 12);
});
