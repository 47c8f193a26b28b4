import type { Vec3 } from '../../math/vec3.ts';

/** Dominant wavelengths of the sRGB primaries red, green, blue [m]. */
export const PRIMARIES: Vec3 = [611e-9, 549e-9, 464e-9];
/** hc/(k_B T) of daylight, Planck's law at 6504 K [m]. */
export const DAYLIGHT_LENGTH = 1.438777e-2 / 6504;
/** Shifts are clamped to this range: below it everything visible is far infrared and dark, above it nothing changes any more. */
export const TINT_RANGE = [0.01, 1e6] as const;

/**
 * The colour of light of linear sRGB `rgb` after a Doppler shift by D, without the D⁴ of beaming, in the *approximate* colours; observerColor.ts is
 * the spectral counterpart. The light is assumed to be daylight (a blackbody of 6504 K) reflected in three broad bands: reflectance r at and above
 * 611 nm, g at 549 nm, b at and below 464 nm, interpolated smoothly in ln λ. Each primary λ shows the light emitted
 * at Dλ: ρ(Dλ) · D⁵P(Dλ)/P(λ) / D⁴. White takes the colours of a blackbody at D·6504 K, and colours fade where the visible
 * comes from the infrared or the ultraviolet. `mix` in 0…1 is an exponent of D. Identity at D = 1. docs/physics.md §7.10.
 * @example
 * dopplerTint([0.8, 0.4, 0.2], 1, 1); // [0.8, 0.4, 0.2]
 * const [r, , b] = dopplerTint([1, 1, 1], 1.5, 1);
 * b > r; // true
 */
export function dopplerTint(rgb: Vec3, D: number, mix: number): Vec3 {
  const shift = Math.min(Math.max(D ** mix, TINT_RANGE[0]), TINT_RANGE[1]);
  const band = (wavelength: number) => reflectance(rgb, wavelength * shift) * daylightRatio(wavelength, shift);
  return [band(PRIMARIES[0]), band(PRIMARIES[1]), band(PRIMARIES[2])];
}

/** ρ(λ) of the three bands [λ in m]. */
function reflectance([r, g, b]: Vec3, wavelength: number): number {
  const toRed = smoothBetween(wavelength, PRIMARIES[1], PRIMARIES[0]);
  const toGreen = smoothBetween(wavelength, PRIMARIES[2], PRIMARIES[1]);
  return (b + (g - b) * toGreen) * (1 - toRed) + r * toRed;
}

function smoothBetween(wavelength: number, from: number, to: number): number {
  const s = Math.min(Math.max(Math.log(wavelength / from) / Math.log(to / from), 0), 1);
  return s * s * (3 - 2 * s);
}

/** D · P(Dλ)/P(λ) of daylight. */
function daylightRatio(wavelength: number, D: number): number {
  const x = DAYLIGHT_LENGTH / wavelength;
  return (D ** -4 * (Math.exp(x - x / D) * Math.expm1(-x))) / Math.expm1(-x / D);
}
