import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { NANOMETRE, WAVELENGTHS } from '../observer/standardObserver.ts';
import { Y_BAR } from '../tables/cie1931.ts';

/** h [J s] and k_B [J/K], exact in the SI of 2019. */
const PLANCK = 6.626_070_15e-34;
const BOLTZMANN = 1.380_649e-23;

/** The second radiation constant c₂ = hc/k_B [m K]. */
export const SECOND_RADIATION = (PLANCK * SPEED_OF_LIGHT) / BOLTZMANN;

/**
 * ln B(λ, T) of a blackbody, up to a constant: B = λ⁻⁵/(exp(c₂/λT) − 1), λ [m], T [K].
 * A logarithm, because at 1 K the visible part is e^−25,000 of daylight's. docs/physics.md §7.1; Rybicki & Lightman, §1.5.
 * @example
 * // A blackbody of 5800 K at 500 nm is 2.82 times as bright as one of 4800 K.
 * Math.exp(logPlanck(500e-9, 5800) - logPlanck(500e-9, 4800)); // 2.824
 */
export function logPlanck(wavelength: number, T: number): number {
  return -5 * Math.log(wavelength) - logExpm1(SECOND_RADIATION / (wavelength * T));
}

/** ln(eˣ − 1), without overflow for large x. */
export const logExpm1 = (x: number): number => (x > 40 ? x : Math.log(Math.expm1(x)));

/**
 * ln Y(T): the luminance ∫ ȳ B dλ of a blackbody of T [K], in the unit of `logPlanck`. Finite from 1 K to 1e12 K and beyond.
 * @example
 * // A filament of 3000 K is 5.4 times as bright as one of 2500 K.
 * Math.exp(logLuminance(3000) - logLuminance(2500)); // 5.37
 */
export function logLuminance(T: number): number {
  const logs = WAVELENGTHS.map((wavelength) => logPlanck(wavelength, T));
  const largest = Math.max(...logs);
  const sum = logs.reduce((total, log, i) => total + Y_BAR[i] * Math.exp(log - largest), 0);
  return largest + Math.log(sum * NANOMETRE);
}
