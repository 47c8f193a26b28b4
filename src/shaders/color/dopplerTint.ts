import { clamp, exp, Fn, log, max, mix, select, smoothstep, vec3 } from 'three/tsl';
import { DAYLIGHT_LENGTH, PRIMARIES, TINT_RANGE } from '../../spectrum/doppler/dopplerTint.ts';
import type { Float, Vec3 } from '../types.ts';

const [LOG_RED, LOG_GREEN, LOG_BLUE] = PRIMARIES.map(Math.log);
const LOG_RANGE = [Math.log(TINT_RANGE[0]), Math.log(TINT_RANGE[1])] as const;

/** ρ(λ) for ln λ = `logWavelength`: r, g, b at the primaries, smooth between, constant outside. */
const reflectance = (rgb: Vec3, logWavelength: Float): Float => {
  const toGreen = smoothstep(LOG_BLUE, LOG_GREEN, logWavelength);
  const toRed = smoothstep(LOG_GREEN, LOG_RED, logWavelength);
  return mix(mix(rgb.z, rgb.y, toGreen), rgb.x, toRed);
};

/** (e^x − 1)/(e^{x/D} − 1) = (e^x − 1) e^{−y}/(1 − e^{−y}), y = x/D; the denominator by its series for small y. */
const planckRatio = (x: number, inverseD: Float): Float => {
  const y = inverseD.mul(x).toVar();
  const fall = exp(y.negate()).toVar();
  const series = y.mul(y.mul(y.div(-3).add(1)).div(-2).add(1));
  return fall.mul(Math.expm1(x)).div(select(y.lessThan(0.02), series, fall.oneMinus()));
};

/**
 * Approximate colour after a Doppler shift by D^amount, without the D⁴ of beaming; the model is described in spectrum/doppler/dopplerTint.ts.
 * `rgb` linear sRGB, D > 0, `amount` 0…1. Identity at D = 1. docs/physics.md §7.10.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * // What an orange wall looks like at D = 1.5.
 * const color = dopplerTint(vec3(1, 0.5, 0.1), float(1.5), float(1));
 */
export const dopplerTint = Fn(
  ([rgb, D, amount]: [Vec3, Float, Float]): Vec3 => {
    const logShift = clamp(log(max(D, 1e-20)).mul(amount), ...LOG_RANGE).toVar();
    const inverse = exp(logShift.negate()).toVar();
    const square = inverse.mul(inverse).toVar();
    const band = (wavelength: number): Float =>
      reflectance(rgb, logShift.add(Math.log(wavelength))).mul(planckRatio(DAYLIGHT_LENGTH / wavelength, inverse));
    return vec3(band(PRIMARIES[0]), band(PRIMARIES[1]), band(PRIMARIES[2])).mul(square.mul(square));
  },
  { rgb: 'vec3', D: 'float', amount: 'float', return: 'vec3' },
);
