import { clamp, dot, exp2, Fn, log2, max, mix, pow, select, vec3 } from 'three/tsl';
import type { Mat3 } from '../../math/mat3.ts';
import { AGX } from '../../spectrum/display/agx.ts';
import { MAX_RADIANCE, NEUTRAL, type ToneMapping } from '../../spectrum/display/toneMap.ts';
import type { Float, Vec3 } from '../types.ts';

const LAYOUT = { rgb: 'vec3', exposure: 'float', return: 'vec3' } as const;

const exposed = (rgb: Vec3, exposure: Float): Vec3 => clamp(rgb.mul(exp2(exposure)), -MAX_RADIANCE, MAX_RADIANCE);

/**
 * Linear sRGB radiance → linear sRGB to display, 0…1, still to be encoded: times 2^exposure [EV], then the neutral curve (spectrum/display/toneMap.ts).
 * @example
 * import { float, vec3 } from 'three/tsl';
 * const displayed = toneMapNeutral(vec3(4, 2, 1), float(-1));
 */
export const toneMapNeutral = Fn(([rgb, exposure]: [Vec3, Float]): Vec3 => {
  const color = max(exposed(rgb, exposure), 0).toVar();
  const peak = max(color.x, max(color.y, color.z)).toVar();
  const room = 1 - NEUTRAL.shoulder;
  const newPeak = peak
    .add(room - NEUTRAL.shoulder)
    .reciprocal()
    .mul(room * room)
    .oneMinus()
    .toVar();
  const white = peak.sub(newPeak).mul(NEUTRAL.desaturation).add(1).reciprocal().oneMinus();
  const compressed = mix(color.mul(newPeak.div(max(peak, 1e-20))), vec3(newPeak), white);
  return select(peak.lessThanEqual(NEUTRAL.shoulder), color, compressed);
}, LAYOUT);

/**
 * As `toneMapNeutral`, with the AgX curve (spectrum/display/agx.ts).
 * @example
 * import { float, vec3 } from 'three/tsl';
 * const displayed = toneMapAgx(vec3(4, 2, 1), float(-1));
 */
export const toneMapAgx = Fn(([rgb, exposure]: [Vec3, Float]): Vec3 => {
  const [least, most] = AGX.stops;
  const stops = log2(max(transform(AGX.inset, exposed(rgb, exposure).toVar()), 1e-10));
  const x = clamp(stops.sub(least).div(most - least), 0, 1).toVar();
  const signal = AGX.sigmoid.reduceRight<Vec3>((sum, coefficient) => sum.mul(x).add(coefficient), vec3(0)).toVar();
  const light = pow(max(transform(AGX.outset, signal), 0), vec3(AGX.exponent)).toVar();
  return clamp(transform(AGX.toSrgb, light), 0, 1);
}, LAYOUT);

/**
 * As `toneMapNeutral`, but clipped to 0…1.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * const displayed = toneMapLinear(vec3(4, 2, 1), float(-1));
 */
export const toneMapLinear = Fn(([rgb, exposure]: [Vec3, Float]): Vec3 => clamp(exposed(rgb, exposure), 0, 1), LAYOUT);

export const toneMaps = { neutral: toneMapNeutral, agx: toneMapAgx, linear: toneMapLinear } as const satisfies Record<
  ToneMapping,
  unknown
>;

const transform = (m: Mat3, v: Vec3): Vec3 => {
  const row = (i: number): Float => dot(vec3(m[3 * i], m[3 * i + 1], m[3 * i + 2]), v);
  return vec3(row(0), row(1), row(2));
};
