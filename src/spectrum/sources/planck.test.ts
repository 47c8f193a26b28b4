import { expect, test } from 'vitest';
import { judged } from '../../../tests/support/spectra.ts';
import { logLuminance, logPlanck, SECOND_RADIATION } from './planck.ts';

test.each(judged.planck)('B of %d K at %d nm agrees with colour-science', (T, nanometres, expected) => {
  const ratio = Math.exp(logPlanck(nanometres * 1e-9, T) - logPlanck(560e-9, T));
  expect(ratio / expected).toBeCloseTo(1, 6);
});

test('c₂ gives the constant of Wien’s displacement law, 2.897771955 mm K (CODATA 2018)', () => {
  // The maximum of x⁵/(eˣ − 1) is at x = 5 + W(−5 e⁻⁵).
  expect(SECOND_RADIATION / 4.965114231744276).toBeCloseTo(2.897771955e-3, 12);
});

/** ln Y over ln T. */
const steepness = (T: number) => (logLuminance(1.001 * T) - logLuminance(T)) / Math.log(1.001);

test('its luminance follows Wien at low T and Rayleigh–Jeans at high T', () => {
  // At 100 K all visible light is at the red end: d ln Y/d ln T = hc/(λ k_B T).
  expect(steepness(100) / (1.438776877e-2 / (825e-9 * 100))).toBeCloseTo(1, 1);
  expect(steepness(1e9)).toBeCloseTo(1, 4);
});

test('it is finite from 1 K to 1e12 K', () => {
  for (const T of [1, 10, 1e3, 1e6, 1e12]) expect(Number.isFinite(logLuminance(T))).toBe(true);
});

test('the luminance of a moving blackbody follows L_λ′(λ) = D⁵ L_λ(Dλ)', () => {
  for (const D of [0.5, 1.3, 2])
    for (const wavelength of [400e-9, 700e-9]) {
      const shifted = 5 * Math.log(D) + logPlanck(D * wavelength, 5000);
      expect(shifted).toBeCloseTo(logPlanck(wavelength, 5000 * D), 10);
    }
});
