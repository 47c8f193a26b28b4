import { dot, type Vec3 } from '../../math/vec3.ts';
import { interpolateTable, NANOMETRE, VISIBLE } from '../observer/standardObserver.ts';
import { BLUE, GREEN, RED } from '../tables/mallettYuksel.ts';

/**
 * A spectral filter: the reflectance of a surface, a coloured glass before a light, a texel of a dome. Light is
 * multiplied by ρ(λ) = r·b_r(λ) + g·b_g(λ) + b·b_b(λ) within `VISIBLE`, by `uv` at shorter wavelengths and by `ir` at longer ones;
 * b are the basis functions of Mallett and Yuksel 2019, so `rgb` is the linear sRGB of the surface in daylight.
 * `uv` and `ir` are invisible at rest; a Doppler shift makes them visible. docs/physics.md §7.3.
 */
export interface SpectralFilter {
  /** Weights of the three basis functions within `VISIBLE`: linear sRGB in daylight. */
  readonly rgb: Vec3;
  /** At wavelengths shorter than `VISIBLE`, 0 … 1. */
  readonly uv: number;
  /** At wavelengths longer than `VISIBLE`, 0 … 1. */
  readonly ir: number;
  /** The difference of a reflectance that is known at every wavelength from its bands, times a factor. */
  readonly residual?: FilterResidual;
}

/** What a reflectance has besides its bands: share · (reflectance − bands). */
export interface FilterResidual {
  /** The difference at a wavelength [m]; with a `width` [m], steps of the bands are averaged. */
  readonly at: (wavelength: number, width?: number) => number;
  /** Factor, 0 … 1. */
  readonly share: number;
}

/** Ends of the basis [m]: outside them, up to the ends of `VISIBLE` and beyond (unless `uv` or `ir` are given), it is constant. */
export const BASIS_RANGE = [380e-9, 780e-9] as const;
const BASIS_STEP = 5 * NANOMETRE;

/** The published functions sum to 1 within 1e-5; here they are normalized, so that white is 1 at every wavelength. */
const [B_RED, B_GREEN, B_BLUE] = [RED, GREEN, BLUE].map((band) =>
  band.map((value, i) => value / (RED[i] + GREEN[i] + BLUE[i])),
);

/** b_r, b_g, b_b at a wavelength [m], of sum 1: linear between the published values every 5 nm, constant outside 380…780 nm. */
export function basisAt(wavelength: number): Vec3 {
  const within = Math.min(Math.max(wavelength, BASIS_RANGE[0]), BASIS_RANGE[1]);
  const place = Math.min((within - BASIS_RANGE[0]) / BASIS_STEP, RED.length - 1);
  return [interpolateTable(B_RED, place), interpolateTable(B_GREEN, place), interpolateTable(B_BLUE, place)];
}

/** The basis at its ends: the weights of r, g and b in the default `uv` and `ir`, about a third each. */
export const BASIS_ENDS: { readonly uv: Vec3; readonly ir: Vec3 } = {
  uv: basisAt(BASIS_RANGE[0]),
  ir: basisAt(BASIS_RANGE[1]),
};

/**
 * The filter of a linear sRGB colour; by default `uv` and `ir` continue the basis at its ends.
 * @example
 * filterFromRgb([0.5, 0.5, 0.5]); // { rgb: [0.5, 0.5, 0.5], uv: 0.5, ir: 0.5 }
 */
export const filterFromRgb = (
  rgb: Vec3,
  uv = dot(BASIS_ENDS.uv, rgb),
  ir = dot(BASIS_ENDS.ir, rgb),
): SpectralFilter => ({ rgb, uv, ir });

/**
 * Transmits everything.
 * @example
 * reflectanceAt(WHITE_FILTER, 555e-9); // 1.00
 */
export const WHITE_FILTER: SpectralFilter = { rgb: [1, 1, 1], uv: 1, ir: 1 };

/**
 * ρ(λ) of a filter at a wavelength [m]; with a `width` [m], steps that cross an end of `VISIBLE` are averaged.
 * @example
 * const leaf = filterFromRgb([0.05, 0.12, 0.03], 0.05, 0.5);
 * reflectanceAt(leaf, 900e-9); // 0.5
 */
export function reflectanceAt({ rgb, uv, ir, residual: rest }: SpectralFilter, wavelength: number, width = 0): number {
  const ultraviolet = stepFraction(VISIBLE[0] - wavelength, width);
  const infrared = stepFraction(wavelength - VISIBLE[1], width);
  const bands = (1 - ultraviolet - infrared) * dot(basisAt(wavelength), rgb) + ultraviolet * uv + infrared * ir;
  return rest ? bands + residualAt(rest, wavelength, width) : bands;
}

/** What the residual adds to the bands at a wavelength [m]. */
export const residualAt = ({ at, share }: FilterResidual, wavelength: number, width = 0): number =>
  share * at(wavelength, width);

/** The fraction of a step that lies past an edge, if its middle is past it by `beyond`. */
export function stepFraction(beyond: number, width: number): number {
  if (width <= 0) return beyond > 0 ? 1 : 0;
  return Math.min(Math.max(beyond / width + 0.5, 0), 1);
}
