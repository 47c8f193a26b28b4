import { clamp, exp, Fn, float, log, max, min, pow, select, vec3 } from 'three/tsl';
import { CHANNEL_POWER, ENDS, MONOCHROMATIC_KNOTS, PRIMARY_KNOTS } from '../../spectrum/doppler/historicalShifts.ts';
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

/** A hat over its neighbours. */
function response(knot: number, wavelength: Float): Float {
  const [from, at, to] = [PRIMARY_KNOTS[knot - 1]!, PRIMARY_KNOTS[knot]!, PRIMARY_KNOTS[knot + 1]!];
  return max(
    min(
      wavelength.sub(from).div(at - from),
      wavelength
        .negate()
        .add(to)
        .div(to - at),
    ),
    0,
  );
}

/**
 * `primaryShift` of spectrum/doppler/historicalShifts.ts. `rgb` linear sRGB, D > 0, `amount` 0…1.
 * @example
 * import { float, vec3 } from 'three/tsl';
 * // A green wall at D = 1.2, each primary shifted by itself.
 * const color = primaryShift(vec3(0, 1, 0), float(1.2), float(1));
 */
export const primaryShift = Fn(
  ([rgb, D, amount]: [Vec3, Float, Float]): Vec3 => {
    const stretch = stretchOf(D, amount);
    const [, blue, green, red] = PRIMARY_KNOTS;
    const seen = [red, green, blue].map((at) => stretch.mul(at).toVar());
    const channel = (k: number): Float =>
      rgb.x
        .mul(response(k, seen[0]!))
        .add(rgb.y.mul(response(k, seen[1]!)))
        .add(rgb.z.mul(response(k, seen[2]!)));
    return vec3(channel(3), channel(2), channel(1));
  },
  { rgb: 'vec3', D: 'float', amount: 'float', return: 'vec3' },
);
