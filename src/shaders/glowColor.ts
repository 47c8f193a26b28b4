import { clamp, dot, Fn, max, vec3 } from 'three/tsl';
import { LUMINANCE } from '../spectrum/observerColor.ts';
import { DAYLIGHT_COLOR, FITS, RANGE, TO_SRGB } from '../spectrum/planckian.ts';
import type { Float, Vec3 } from './types.ts';

type Polynomial = readonly [number, number, number];
const polynomial = ([a, b, c]: Polynomial, t: Float): Float => t.mul(c).add(b).mul(t).add(a);
const fitted = ([over, under]: readonly [Polynomial, Polynomial], t: Float): Float =>
  polynomial(over, t).div(polynomial(under, t)).toVar();

/** Approximate colour of what glows at T [K], linear sRGB of luminance 1, daylight white (spectrum/planckian.ts). */
export const glowColor = Fn(
  ([temperature]: [Float]): Vec3 => {
    const t = clamp(temperature, ...RANGE).toVar();
    const [u, v] = [fitted(FITS.u, t), fitted(FITS.v, t)];
    const half = v.mul(2).reciprocal().toVar();
    const xyz = vec3(u.mul(3).mul(half), 1, u.add(v.mul(10)).sub(4).negate().mul(half)).toVar();
    const [r, g, b] = TO_SRGB.map((row, k) => max(dot(vec3(...row), xyz), 0).div(DAYLIGHT_COLOR[k]));
    const color = vec3(r, g, b).toVar();
    return color.div(dot(color, vec3(...LUMINANCE)));
  },
  { temperature: 'float', return: 'vec3' },
);
