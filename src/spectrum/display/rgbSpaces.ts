import { IDENTITY, invert, type Mat3, multiply, transform } from '../../math/mat3.ts';
import type { Vec3 } from '../../math/vec3.ts';

type Chromaticity = readonly [x: number, y: number];

/** White point of sRGB and Display P3: CIE D65. */
const D65: Chromaticity = [0.3127, 0.329];

/** XYZ of a chromaticity at luminance 1. */
const xyzOf = ([x, y]: Chromaticity): Vec3 => [x / y, 1, (1 - x - y) / y];
const columns = (a: Vec3, b: Vec3, c: Vec3): Mat3 => [0, 1, 2].flatMap((i) => [a[i], b[i], c[i]]);
const inverse = (m: Mat3): Mat3 => invert(m) ?? IDENTITY;

/** Linear RGB → XYZ of a display with three primaries, whose white is D65 at Y = 1. Source: SMPTE RP 177-1993. */
function toXyz(red: Chromaticity, green: Chromaticity, blue: Chromaticity): Mat3 {
  const primaries = columns(xyzOf(red), xyzOf(green), xyzOf(blue));
  const [r, g, b] = transform(inverse(primaries), xyzOf(D65));
  return multiply(primaries, [r, 0, 0, 0, g, 0, 0, 0, b]);
}

/**
 * Linear sRGB → XYZ relative to D65, row by row (IEC 61966-2-1). The renderers' own white is `DAYLIGHT`: see `toLinearSrgb`.
 * @example
 * import { mat3 } from 'slowlight/math';
 * mat3.transform(SRGB_TO_XYZ, [1, 1, 1]); // [0.950, 1.000, 1.089]: D65
 */
export const SRGB_TO_XYZ: Mat3 = toXyz([0.64, 0.33], [0.3, 0.6], [0.15, 0.06]);
/**
 * XYZ relative to D65 → linear sRGB, row by row: the inverse of `SRGB_TO_XYZ`.
 * @example
 * import { mat3 } from 'slowlight/math';
 * mat3.transform(XYZ_TO_SRGB, mat3.transform(SRGB_TO_XYZ, [1, 0.5, 0])); // [1.000, 0.500, 0.000]
 */
export const XYZ_TO_SRGB: Mat3 = inverse(SRGB_TO_XYZ);
/**
 * Linear Display P3 → XYZ relative to D65, row by row (SMPTE EG 432-1 primaries).
 * @example
 * import { mat3 } from 'slowlight/math';
 * mat3.transform(P3_TO_XYZ, [1, 1, 1]); // [0.950, 1.000, 1.089]: D65
 */
export const P3_TO_XYZ: Mat3 = toXyz([0.68, 0.32], [0.265, 0.69], [0.15, 0.06]);
/**
 * XYZ relative to D65 → linear Display P3, row by row: the inverse of `P3_TO_XYZ`.
 * @example
 * import { mat3 } from 'slowlight/math';
 * mat3.transform(XYZ_TO_P3, mat3.transform(P3_TO_XYZ, [1, 0.5, 0])); // [1.000, 0.500, 0.000]
 */
export const XYZ_TO_P3: Mat3 = inverse(P3_TO_XYZ);
/**
 * Linear sRGB → linear Display P3, without gamut mapping. White stays white.
 * @example
 * import { mat3 } from 'slowlight/math';
 * mat3.transform(SRGB_TO_P3, [1, 0, 0]); // [0.822, 0.033, 0.017]
 */
export const SRGB_TO_P3: Mat3 = multiply(XYZ_TO_P3, SRGB_TO_XYZ);
