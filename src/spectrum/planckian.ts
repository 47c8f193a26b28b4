import type { Vec3 } from '../math/vec3.ts';

/** Between these a blackbody's colour is told [K]; beyond them it is that of the nearer one. */
const RANGE = [1000, 10000] as const;

/**
 * What files mean by a colour temperature T [K]: linear sRGB of a blackbody, scaled to the luminance 1; what lies outside of sRGB is clipped first.
 * UsdLux defines it so, by a fit and for a display whose white is D65. Light that is computed as light is `whiteOf` a thermal spectrum, where
 * daylight of 6504 K is white: from 1900 K on blackbodyColor(T)/blackbodyColor(6504 K) is that within 2 % of its brightest part.
 * Source: Krystek 1985, "An algorithm to calculate correlated colour temperature", eq. for u(T), v(T) (CIE 1960); within 1.5e-4 in u and v.
 */
export function blackbodyColor(T: number): Vec3 {
  const t = Math.min(Math.max(T, RANGE[0]), RANGE[1]);
  const u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
  const v = (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  // XYZ/Y from x = 3u/(2u − 8v + 4), y = 2v/(2u − 8v + 4).
  const X = (3 * u) / (2 * v);
  const Z = (4 - u - 10 * v) / (2 * v);
  const r = Math.max(3.2404542 * X - 1.5371385 - 0.4985314 * Z, 0);
  const g = Math.max(-0.969266 * X + 1.8760108 + 0.041556 * Z, 0);
  const b = Math.max(0.0556434 * X - 0.2040259 + 1.0572252 * Z, 0);
  const luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  return [r / luminance, g / luminance, b / luminance];
}
