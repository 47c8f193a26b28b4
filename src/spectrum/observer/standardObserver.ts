import type { Vec3 } from '../../math/vec3.ts';
import { X_BAR, Y_BAR, Z_BAR } from '../tables/cie1931.ts';

/**
 * The visible range of the CIE 1931 2° standard observer [m]: the wavelengths 360 … 830 nm of its table with half a nanometre
 * on either side. For an observer at rest all else is invisible.
 * @example
 * const [shortest, longest] = VISIBLE;
 * longest / shortest; // 2.31: from D = 2.31 on all that is seen was infrared, or less than 1/2.31 ultraviolet
 */
export const VISIBLE: readonly [shortest: number, longest: number] = [359.5e-9, 830.5e-9];
/** Width of the steps in which spectra are integrated [m]. */
export const NANOMETRE = 1e-9;
/**
 * The wavelengths of the standard observer's table [m]: 360, 361 … 830 nm.
 * @example
 * WAVELENGTHS.length; // 471
 * WAVELENGTHS[0]; // 360.0e-9 m
 */
export const WAVELENGTHS: readonly number[] = X_BAR.map((_, i) => (360 + i) / 1e9);

/**
 * x̄, ȳ, z̄ of the CIE 1931 2° standard observer at a wavelength [m]: as published at whole nanometres, linear between, 0 outside.
 * @example
 * colorMatching(555e-9)[1]; // 1.00
 * colorMatching(1000e-9); // [0, 0, 0]
 */
export function colorMatching(wavelength: number): Vec3 {
  const place = wavelength / NANOMETRE - 360;
  return [interpolateTable(X_BAR, place), interpolateTable(Y_BAR, place), interpolateTable(Z_BAR, place)];
}

/** Tolerance at the ends of a table for rounding in places computed from wavelengths in metres. */
const ROUNDING = 1e-9;

/** Linear interpolation in a table of two or more values at 0, 1, 2 …; 0 outside. */
export function interpolateTable(values: readonly number[], place: number): number {
  if (!(place >= -ROUNDING && place <= values.length - 1 + ROUNDING)) return 0;
  const i = Math.min(Math.max(Math.floor(place), 0), values.length - 2);
  return values[i] + (values[i + 1] - values[i]) * (place - i);
}

/**
 * ∫ (x̄, ȳ, z̄) S dλ of a spectrum over wavelength, summed at whole nanometres.
 * @example
 * // The equal-energy spectrum: the three functions have the same area.
 * const [X, Y, Z] = tristimulus(() => 1e9);
 * Y; // 106.9
 * X / Y; // 1.000
 * Z / Y; // 1.000
 */
export function tristimulus(spectrum: (wavelength: number) => number): Vec3 {
  let [X, Y, Z] = [0, 0, 0];
  for (let i = 0; i < WAVELENGTHS.length; i++) {
    const value = spectrum(WAVELENGTHS[i]) * NANOMETRE;
    X += X_BAR[i] * value;
    Y += Y_BAR[i] * value;
    Z += Z_BAR[i] * value;
  }
  return [X, Y, Z];
}
