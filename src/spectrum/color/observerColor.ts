import { IDENTITY, invert, type Mat3, transform, transpose } from '../../math/mat3.ts';
import { addScaled, type Vec3, ZERO } from '../../math/vec3.ts';
import { colorMatching, NANOMETRE, tristimulus } from '../observer/standardObserver.ts';
import { basisAt, reflectanceAt, type SpectralFilter, WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import {
  DAYLIGHT,
  type LightSpectrum,
  linesOf,
  meanRadiance,
  type SpectralLine,
  spectralRadiance,
} from '../sources/lightSpectrum.ts';

/** XYZ of the basis functions in `DAYLIGHT`, one per column. */
const DAYLIGHT_XYZ: Mat3 = transpose(
  [0, 1, 2].flatMap((j) =>
    tristimulus((wavelength) => basisAt(wavelength)[j] * spectralRadiance(DAYLIGHT, wavelength)),
  ),
);

/**
 * N: XYZ → linear sRGB, row by row, defined so that a surface of linear sRGB (r, g, b) shows (r, g, b) in daylight at rest: the inverse of
 * the XYZ of the three basis functions in `DAYLIGHT`, whose luminance is 1. It differs by up to 0.06 from the matrix of IEC 61966-2-1, whose white is
 * CIE D65. docs/physics.md §7.2.
 */
export const XYZ_TO_RENDER_SRGB: Mat3 = invert(DAYLIGHT_XYZ) ?? IDENTITY;

/**
 * Luminance of linear sRGB in the renderers: that of the three basis functions in `DAYLIGHT`, (0.218, 0.711, 0.071), of sum 1.
 * @example
 * const [r, g, b] = LUMINANCE_WEIGHTS;
 * r + g + b; // 1
 */
export const LUMINANCE_WEIGHTS: Vec3 = [DAYLIGHT_XYZ[3], DAYLIGHT_XYZ[4], DAYLIGHT_XYZ[5]];

/**
 * N·XYZ: the renderers' linear sRGB, white in `DAYLIGHT`. Channels are negative for colours outside sRGB; only a display clips them.
 * @example
 * // The XYZ of daylight of luminance 1 is white.
 * const daylight = tristimulus((wavelength) => spectralRadiance(DAYLIGHT, wavelength));
 * toLinearSrgb(daylight); // [1.0, 1.0, 1.0]
 */
export const toLinearSrgb = (xyz: Vec3): Vec3 => transform(XYZ_TO_RENDER_SRGB, xyz);

/**
 * Linear sRGB of light of luminance 1, at rest; (1, 1, 1) for `DAYLIGHT`.
 * @example
 * colorOfSpectrum(DAYLIGHT); // [1.00, 1.00, 1.00]
 * // Sodium's yellow lies outside of sRGB: blue is negative.
 * const [r, g, b] = colorOfSpectrum({ kind: 'lines', lines: [{ wavelength: 589.3e-9, weight: 1 }] });
 * r > g && b < 0; // true
 */
export const colorOfSpectrum = (spectrum: LightSpectrum): Vec3 =>
  observedColor(WHITE_FILTER, WHITE_FILTER, spectrum, 1, 1);

/**
 * Observed colour, linear sRGB, of a surface with the filter `a` in light with the filter `k` and the spectrum S (of luminance 1), integrated at
 * every nanometre: the reference for tables and shaders. The light reaches the surface shifted by `Din`, and the observer shifted
 * again by `Dout`; D = Din·Dout (D = ν_observed/ν_emitted):
 *
 *   N ∫ cmf(λ) a(Dout λ) k(D λ) D⁵ S(D λ) dλ / D⁴
 *
 * The factor D⁴ of the radiance over all wavelengths is applied as beaming, elsewhere. Directly visible emitters have Din = 1. docs/physics.md §7.4.
 * @example
 * // A grey wall in daylight that approaches with D = 2 looks bluish.
 * const grey = filterFromRgb([0.5, 0.5, 0.5]);
 * const [r, , b] = observedColor(grey, WHITE_FILTER, DAYLIGHT, 1, 2);
 * b > r; // true
 */
export function observedColor(
  a: SpectralFilter,
  k: SpectralFilter,
  spectrum: LightSpectrum,
  Din: number,
  Dout: number,
): Vec3 {
  const D = Din * Dout;
  if (spectrum.kind === 'lines') return observedLines(a, k, linesOf(spectrum), Din, D);
  const xyz = tristimulus(
    (wavelength) =>
      filterMean(a, Dout * wavelength, Dout * NANOMETRE) *
      filterMean(k, D * wavelength, D * NANOMETRE) *
      D *
      meanRadiance(spectrum, D * wavelength, D * NANOMETRE),
  );
  return toLinearSrgb(xyz);
}

/** Mean of a filter over a step. White is handled apart, because evaluating its bands would be most of the work. */
const filterMean = (bands: SpectralFilter, wavelength: number, width: number): number =>
  bands === WHITE_FILTER ? 1 : reflectanceAt(bands, wavelength, width);

/** A line emitted at λ is at λ/Din for the surface and at λ/D for the observer; its radiance is multiplied by D⁴. */
function observedLines(
  a: SpectralFilter,
  k: SpectralFilter,
  lines: readonly SpectralLine[],
  Din: number,
  D: number,
): Vec3 {
  let xyz = ZERO;
  for (const { wavelength, weight } of lines) {
    const radiance = weight * reflectanceAt(k, wavelength) * reflectanceAt(a, wavelength / Din);
    xyz = addScaled(xyz, colorMatching(wavelength / D), radiance);
  }
  return toLinearSrgb(xyz);
}
