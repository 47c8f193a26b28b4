import { expect, test } from 'vitest';
import { judged } from '../../../tests/support/spectra.ts';
import { colorMatching, NANOMETRE, tristimulus, VISIBLE, WAVELENGTHS } from './standardObserver.ts';

test('the standard observer agrees with colour-science', () => {
  judged.matching.forEach((expected, i) => {
    colorMatching((360 + 10 * i) * NANOMETRE).forEach((value, k) => void expect(value).toBeCloseTo(expected[k], 8));
  });
});

test('it is linear between whole nanometres, and 0 outside the visible', () => {
  const [a, b] = [colorMatching(600e-9), colorMatching(601e-9)];
  colorMatching(600.25e-9).forEach((value, k) => void expect(value).toBeCloseTo(0.75 * a[k] + 0.25 * b[k], 9));
  for (const wavelength of [0, 359.9e-9, 830.1e-9, 1, Number.NaN, Number.POSITIVE_INFINITY])
    expect(colorMatching(wavelength)).toEqual([0, 0, 0]);
  expect([WAVELENGTHS[0] - VISIBLE[0], VISIBLE[1] - WAVELENGTHS[470]]).toEqual(
    [0.5e-9, 0.5e-9].map((x) => expect.closeTo(x, 15)),
  );
});

test('it is most sensitive at 555 nm, and equal energy is white', () => {
  expect(colorMatching(555e-9)[1]).toBeCloseTo(1, 12);
  const [X, Y, Z] = tristimulus(() => 1);
  expect(X / Y).toBeCloseTo(1, 3);
  expect(Z / Y).toBeCloseTo(1, 3);
});
