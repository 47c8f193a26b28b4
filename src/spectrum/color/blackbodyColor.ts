import { dot, type Vec3 } from '../../math/vec3.ts';
import { LUMINANCE_WEIGHTS } from './observerColor.ts';

/** Range of the fit [K]; temperatures are clamped to it. */
export const KRYSTEK_RANGE = [1000, 10000] as const;
/** Krystek's fits: numerator and denominator of u(T) and of v(T), coefficients from the constant up. */
export const KRYSTEK_FITS = {
  u: [
    [0.860117757, 1.54118254e-4, 1.28641212e-7],
    [1, 8.42420235e-4, 7.08145163e-7],
  ],
  v: [
    [0.317398726, 4.22806245e-5, 4.20481691e-8],
    [1, -2.89741816e-5, 1.61456053e-7],
  ],
} as const;
/** Y of linear sRGB, IEC 61966-2-1. */
const SRGB_LUMINANCE: Vec3 = [0.2126, 0.7152, 0.0722];
/** XYZ to linear sRGB, IEC 61966-2-1. */
export const XYZ_TO_SRGB_ROWS = [
  [3.2404542, -1.5371385, -0.4985314],
  [-0.969266, 1.8760108, 0.041556],
  [0.0556434, -0.2040259, 1.0572252],
] as const;

/**
 * The colour that files mean by a colour temperature T [K], as UsdLux defines it: linear sRGB of a blackbody, clipped to sRGB, then scaled to the
 * luminance 1, with D65 as white. Spectral rendering uses `colorOfSpectrum` of a thermal spectrum instead, with 6504 K as white; above
 * 1900 K, blackbodyColor(T)/blackbodyColor(6504 K) agrees with that within 2 % of the largest channel. docs/physics.md §7.10.
 * Source: Krystek 1985, "An algorithm to calculate correlated colour temperature", eq. for u(T), v(T) (CIE 1960); within 1.5e-4 in u and v.
 * @example
 * blackbodyColor(2856); // [1.84, 0.83, 0.23]: incandescent light
 */
export function blackbodyColor(T: number): Vec3 {
  const t = Math.min(Math.max(T, KRYSTEK_RANGE[0]), KRYSTEK_RANGE[1]);
  const [u, v] = [fitted(KRYSTEK_FITS.u, t), fitted(KRYSTEK_FITS.v, t)];
  // XYZ/Y from x = 3u/(2u − 8v + 4), y = 2v/(2u − 8v + 4).
  const X = (3 * u) / (2 * v);
  const Z = (4 - u - 10 * v) / (2 * v);
  const channel = (row: Vec3): number => Math.max(dot(row, [X, 1, Z]), 0);
  return atUnitLuminance(
    [channel(XYZ_TO_SRGB_ROWS[0]), channel(XYZ_TO_SRGB_ROWS[1]), channel(XYZ_TO_SRGB_ROWS[2])],
    SRGB_LUMINANCE,
  );
}

/** Coefficients of a + bt + ct². */
export type Quadratic = readonly [number, number, number];
const polynomial = ([a, b, c]: Quadratic, t: number): number => a + b * t + c * t * t;
const fitted = ([over, under]: readonly [Quadratic, Quadratic], t: number): number =>
  polynomial(over, t) / polynomial(under, t);

function atUnitLuminance(rgb: Vec3, weights: Vec3): Vec3 {
  const luminance = dot(weights, rgb);
  return [rgb[0] / luminance, rgb[1] / luminance, rgb[2] / luminance];
}

/** White of the approximate colours. */
export const DAYLIGHT_COLOR = blackbodyColor(6504);

/**
 * The colour of a glowing surface at T [K], of luminance 1, in the *approximate* colours: `blackbodyColor` with 6504 K as white.
 * A Doppler shift tints it as any other colour (dopplerTint.ts); spectral rendering shows a blackbody of T·D instead.
 * @example
 * glowColor(6504); // [1, 1, 1]
 */
export function glowColor(T: number): Vec3 {
  const [r, g, b] = blackbodyColor(T);
  return atUnitLuminance([r / DAYLIGHT_COLOR[0], g / DAYLIGHT_COLOR[1], b / DAYLIGHT_COLOR[2]], LUMINANCE_WEIGHTS);
}
