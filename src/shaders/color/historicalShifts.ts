import { clamp, dot, exp, Fn, float, log, max, min, mix, pow, select, vec3 } from 'three/tsl';
import {
  CHANNEL_POWER,
  CORNER_SHARES,
  ENDS,
  MONOCHROMATIC_KNOTS,
  SPECTRUM_CORNERS,
} from '../../spectrum/doppler/historicalShifts.ts';
import type { Float, Vec3 } from '../types.ts';

/** Far beyond it nothing is visible. */
const LOG_RANGE = [-12, 12] as const;

/** D^−amount */
const stretchOf = (D: Float, amount: Float): Float =>
  exp(clamp(log(max(D, 1e-20)).mul(amount), ...LOG_RANGE).negate()).toVar();

/** Linear between the rows of a table, 0 outside. */
function interpolated(table: readonly (readonly [number, ...number[]])[], x: Float, column: number): Float {
  let value: Float = float(0);
  for (let i = table.length - 2; i >= 0; i--) {
    const [a, b] = [table[i]!, table[i + 1]!];
    const slope = (b[column]! - a[column]!) / (b[0] - a[0]);
    const within = x.sub(a[0]).mul(slope).add(a[column]!);
    value = select(x.lessThan(b[0]), within, value);
  }
  return select(x.lessThan(table[0]![0]), float(0), value);
}

function monochromatic(wavelength: Float): Vec3 {
  const ends = interpolated(ENDS, wavelength, 1).toVar();
  const [r, g, b] = [1, 2, 3].map((k) =>
    pow(max(interpolated(MONOCHROMATIC_KNOTS, wavelength, k).mul(ends), 0), 1 / CHANNEL_POWER),
  ) as [Float, Float, Float];
  return vec3(r, g, b);
}

/**
 * `twoWavelengthShift` of spectrum/doppler/historicalShifts.ts. `rgb` linear sRGB, D > 0, `amount` 0…1.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * // A red wall at D = 1.3, as an earlier program drew it.
 * const color = twoWavelengthShift(vec3(1, 0.1, 0.1), float(1.3), float(1));
 */
export const twoWavelengthShift = Fn(
  ([rgb, D, amount]: [Vec3, Float, Float]): Vec3 => {
    const stretch = stretchOf(D, amount);
    const most = max(rgb.x, max(rgb.y, rgb.z)).toVar();
    const c = pow(max(rgb, vec3(0)).div(max(most, 1e-30)), vec3(CHANNEL_POWER)).toVar();
    const { x: r, y: g, z: b } = c;
    const [isRed, isGreen] = [rgb.x.greaterThanEqual(most), rgb.y.greaterThanEqual(most)];
    const isWarm = b.lessThanEqual(g);
    const violet = r.mul(-60).add(440).toVar();
    const dimmed = select(violet.lessThan(420), interpolated(ENDS, violet, 1), float(1));
    const first = select(isRed, select(isWarm, float(490), float(645)), select(isGreen, float(645), violet));
    const firstLight = select(isRed, select(isWarm, b, float(1)), select(isGreen, r, dimmed.reciprocal()));
    const warm = g.sub(b).mul(-65).add(645);
    const cold = g.mul(50).div(max(b, 1e-30)).add(440);
    const second = select(isRed, select(isWarm, warm, cold), select(isGreen, b.mul(-20).add(510), float(510)));
    const secondLight = select(isRed, select(isWarm, float(1), b), select(isGreen, float(1), g));
    const seen = monochromatic(first.mul(stretch).toVar())
      .mul(firstLight)
      .add(monochromatic(second.mul(stretch).toVar()).mul(secondLight));
    return select(most.greaterThan(0), seen.mul(most), vec3(0));
  },
  { rgb: 'vec3', D: 'float', amount: 'float', return: 'vec3' },
);

/**
 * `linearSpectrumShift` of spectrum/doppler/historicalShifts.ts. `rgb` linear sRGB, D > 0, `amount` 0…1.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * // A green wall at D = 1.2, its spectrum straight between the channels.
 * const color = linearSpectrumShift(vec3(0, 1, 0), float(1.2), float(1));
 */
export const linearSpectrumShift = Fn(
  ([rgb, D, amount]: [Vec3, Float, Float]): Vec3 => {
    const [ultraviolet, blue, green, red, infrared] = SPECTRUM_CORNERS;
    const seen = vec3(red, green, blue).div(stretchOf(D, amount)).toVar();
    const values = CORNER_SHARES.map((shares) => vec3(dot(rgb, vec3(...shares))));
    // Of the straight pieces those below are at their ends, and those above have not begun.
    const inside = SPECTRUM_CORNERS.slice(1).reduce((spectrum: Vec3, to, i) => {
      const from = SPECTRUM_CORNERS[i]!;
      return mix(spectrum, values[i + 1]!, clamp(seen.sub(from).div(to - from), 0, 1));
    }, values[0]!);
    return inside.mul(min(seen.div(ultraviolet), 1)).mul(min(vec3(infrared).div(seen), 1));
  },
  { rgb: 'vec3', D: 'float', amount: 'float', return: 'vec3' },
);
