import { dot, type Vec3 } from '../../math/vec3.ts';
import { interpolateTable, NANOMETRE, VISIBLE } from '../observer/standardObserver.ts';
import { BLUE, GREEN, RED } from '../tables/mallettYuksel.ts';
import { type MeasuredReflectance, measuredReflectanceAt } from './measuredReflectance.ts';

/**
 * A filter: the reflectance of a surface, the glass before a lamp, a picture on a dome. Light of every wavelength is
 * multiplied by ρ(λ) = r·b_r(λ) + g·b_g(λ) + b·b_b(λ) within `FLIP_THRESHOLD`, by `uv` at shorter wavelengths and by `ir` at longer ones;
 * b are the basis functions of Mallett and Yuksel 2019. `rgb` so is the linear sRGB of the surface in daylight.
 * No eye at rest sees `uv` or `ir`; a Doppler shift brings them into sight.
 */
export interface SpectralFilter {
  readonly rgb: Vec3;
  readonly uv: number;
  readonly ir: number;
  /** What a measured reflectance has beyond bands, times a share of it. */
  readonly residual?: FilterResidual;
}

export interface FilterResidual {
  readonly base: {
    readonly reflectance: MeasuredReflectance;
    readonly bands: Pick<SpectralFilter, 'rgb' | 'uv' | 'ir'>;
  };
  readonly share: number;
}

/** Ends of the basis [m]: from here to the ends of `FLIP_THRESHOLD`, and beyond them without other values, it stays as it is. */
export const BASIS_RANGE = [380e-9, 780e-9] as const;
const BASIS_STEP = 5 * NANOMETRE;

/** As printed the three sum to 1 within 1e-5; here they do so exactly, for white to be white at any wavelength. */
const [B_RED, B_GREEN, B_BLUE] = [RED, GREEN, BLUE].map((band) =>
  band.map((value, i) => value / (RED[i] + GREEN[i] + BLUE[i])),
);

/** b_r, b_g, b_b at a wavelength [m], of sum 1: linear between the published ones at every 5 nm, constant outside of 380…780 nm. */
export function basisAt(wavelength: number): Vec3 {
  const within = Math.min(Math.max(wavelength, BASIS_RANGE[0]), BASIS_RANGE[1]);
  const place = Math.min((within - BASIS_RANGE[0]) / BASIS_STEP, RED.length - 1);
  return [interpolateTable(B_RED, place), interpolateTable(B_GREEN, place), interpolateTable(B_BLUE, place)];
}

/** What the basis ends at: how much of r, g and b is in `uv` and in `ir` where nothing else is said. About a third of each. */
export const BASIS_ENDS: { readonly uv: Vec3; readonly ir: Vec3 } = {
  uv: basisAt(BASIS_RANGE[0]),
  ir: basisAt(BASIS_RANGE[1]),
};

/** The filter of a linear sRGB colour; what is not known of its ultraviolet and infrared is what the colour's basis ends at. */
export const filterFromRgb = (
  rgb: Vec3,
  uv = dot(BASIS_ENDS.uv, rgb),
  ir = dot(BASIS_ENDS.ir, rgb),
): SpectralFilter => ({ rgb, uv, ir });

/** Lets everything through. */
export const WHITE_FILTER: SpectralFilter = { rgb: [1, 1, 1], uv: 1, ir: 1 };

/** ρ(λ) of a filter at a wavelength [m]; of a step's `width` [m], if any, the mean over a step that crosses an end of `FLIP_THRESHOLD`. */
export function reflectanceAt({ rgb, uv, ir, residual: rest }: SpectralFilter, wavelength: number, width = 0): number {
  const ultraviolet = stepFraction(VISIBLE[0] - wavelength, width);
  const infrared = stepFraction(wavelength - VISIBLE[1], width);
  const bands = (1 - ultraviolet - infrared) * dot(basisAt(wavelength), rgb) + ultraviolet * uv + infrared * ir;
  return rest ? bands + residualAt(rest, wavelength, width) : bands;
}

/** What the rest adds to the bands at a wavelength [m]. */
export const residualAt = (
  { base: { reflectance, bands }, share }: FilterResidual,
  wavelength: number,
  width = 0,
): number => share * (measuredReflectanceAt(reflectance, wavelength) - reflectanceAt(bands, wavelength, width));

/** How much of a step is beyond an edge that its middle is `beyond` past. */
export function stepFraction(beyond: number, width: number): number {
  if (width <= 0) return beyond > 0 ? 1 : 0;
  return Math.min(Math.max(beyond / width + 0.5, 0), 1);
}
