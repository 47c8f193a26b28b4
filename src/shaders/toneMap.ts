import { clamp, exp2, Fn, max, mix, select, vec3 } from 'three/tsl';
import { NEUTRAL } from '../spectrum/toneMap.ts';
import type { Float, Vec3 } from './types.ts';

/** Linear sRGB radiance → linear sRGB to display, 0…1, still to be encoded: times 2^exposure [EV], then a neutral shoulder (spectrum/toneMap.ts). */
export const toneMap = Fn(
  ([rgb, exposure]: [Vec3, Float]): Vec3 => {
    const color = clamp(rgb.mul(exp2(exposure)), 0, NEUTRAL.brightest).toVar();
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
  },
  { rgb: 'vec3', exposure: 'float', return: 'vec3' },
);
