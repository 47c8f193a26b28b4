import { clamp, dot, Fn, max, vec3 } from 'three/tsl';
import {
  DAYLIGHT_COLOR,
  KRYSTEK_FITS,
  KRYSTEK_RANGE,
  type Quadratic,
  XYZ_TO_SRGB_ROWS,
} from '../../spectrum/color/blackbodyColor.ts';
import { LUMINANCE_WEIGHTS } from '../../spectrum/color/observerColor.ts';
import type { Float, Vec3 } from '../types.ts';

const polynomial = ([a, b, c]: Quadratic, t: Float): Float => t.mul(c).add(b).mul(t).add(a);
const fitted = ([over, under]: readonly [Quadratic, Quadratic], t: Float): Float =>
  polynomial(over, t).div(polynomial(under, t)).toVar();

/**
 * Approximate colour of a surface that glows at T [K]: linear sRGB of luminance 1, with daylight as white (spectrum/color/blackbodyColor.ts).
 * @example
 * import { float } from 'three/tsl';
 * const ember = glowColor(float(1200));
 */
export const glowColor = Fn(
  ([temperature]: [Float]): Vec3 => {
    const t = clamp(temperature, ...KRYSTEK_RANGE).toVar();
    const [u, v] = [fitted(KRYSTEK_FITS.u, t), fitted(KRYSTEK_FITS.v, t)];
    const half = v.mul(2).reciprocal().toVar();
    const xyz = vec3(u.mul(3).mul(half), 1, u.add(v.mul(10)).sub(4).negate().mul(half)).toVar();
    const [r, g, b] = XYZ_TO_SRGB_ROWS.map((row, k) => max(dot(vec3(...row), xyz), 0).div(DAYLIGHT_COLOR[k]));
    const color = vec3(r, g, b).toVar();
    return color.div(dot(color, vec3(...LUMINANCE_WEIGHTS)));
  },
  { temperature: 'float', return: 'vec3' },
);
