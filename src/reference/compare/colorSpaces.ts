import { invert, type Mat3, transform } from '../../math/mat3.ts';
import type { Vec3 } from '../../math/vec3.ts';

/** Chromaticities x, y of the primaries and of white, D65. Source: ITU-R BT.709-6, table 1, items 1.3 and 1.4. */
const RED = [0.64, 0.33] as const;
const GREEN = [0.3, 0.6] as const;
const BLUE = [0.15, 0.06] as const;
const WHITE = [0.3127, 0.329] as const;

/** X, Y, Z of a chromaticity at Y = 1. */
const atUnitLuminance = ([x, y]: readonly [number, number]): Vec3 => [x / y, 1, (1 - x - y) / y];

/** Linear sRGB → X, Y, Z divided by those of white: the primaries have their chromaticities and (1, 1, 1) maps to (1, 1, 1). docs/physics.md §7.12. */
const TO_XYZ = whiteIsOne(atUnitLuminance(RED), atUnitLuminance(GREEN), atUnitLuminance(BLUE), atUnitLuminance(WHITE));
const FROM_XYZ = inverse(TO_XYZ);

function whiteIsOne(r: Vec3, g: Vec3, b: Vec3, white: Vec3): Mat3 {
  const primaries = [r[0], g[0], b[0], r[1], g[1], b[1], r[2], g[2], b[2]];
  const luminances = transform(inverse(primaries), white);
  return primaries.map((value, i) => (value * luminances[i % 3]) / white[Math.floor(i / 3)]);
}

function inverse(m: Mat3): Mat3 {
  const result = invert(m);
  if (!result) throw new RangeError('the primaries of a colour space lie on one line');
  return result;
}

/** Linear sRGB → X/X_white, Y/Y_white, Z/Z_white. */
export const toXyz = (rgb: Vec3): Vec3 => transform(TO_XYZ, rgb);
export const fromXyz = (xyz: Vec3): Vec3 => transform(FROM_XYZ, xyz);

/** Y/Y_white of linear sRGB. */
export const luminance = (r: number, g: number, b: number): number => TO_XYZ[3] * r + TO_XYZ[4] * g + TO_XYZ[5] * b;

/** CIE 1976 L*, a*, b* of X, Y, Z divided by those of white. Source: CIE 15:2004, 8.2.1. */
export function lab([x, y, z]: Vec3): Vec3 {
  const [fx, fy, fz] = [lightness(x), lightness(y), lightness(z)];
  return [116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)];
}

const KNEE = 6 / 29;
const lightness = (t: number): number => (t > KNEE ** 3 ? Math.cbrt(t) : t / (3 * KNEE ** 2) + 4 / 29);
