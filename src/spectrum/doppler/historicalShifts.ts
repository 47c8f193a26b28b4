import type { Vec3 } from '../../math/vec3.ts';

/*
 * How earlier programs shifted colours, for comparison with spectra: neither is right, docs/physics.md §7.10. Linear sRGB of any magnitude, without the D⁴ of
 * beaming; `mix` in 0…1 is an exponent of D.
 */

/** The colour of one wavelength, piecewise linear between these [nm; r, g, b], times `ENDS`, to the power 0.8. */
export const MONOCHROMATIC_KNOTS = [
  [380, 1, 0, 1],
  [440, 0, 0, 1],
  [490, 0, 1, 1],
  [510, 0, 1, 0],
  [580, 1, 1, 0],
  [645, 1, 0, 0],
  [780, 1, 0, 0],
] as const;
/** Darker towards the ends of the visible range: [nm; factor]. */
export const ENDS = [
  [380, 0.3],
  [420, 1],
  [700, 1],
  [780, 0.3],
] as const;
/** A channel to this power is the intensity of the wavelength that makes it; its inverse is that of a wavelength's colour. */
export const CHANNEL_POWER = 1.25;

function interpolated(table: readonly (readonly [number, ...number[]])[], x: number, column: number): number {
  const next = table.findIndex(([at]) => x < at);
  if (next <= 0) return 0;
  const [a, b] = [table[next - 1]!, table[next]!];
  return a[column]! + ((b[column]! - a[column]!) * (x - a[0])) / (b[0] - a[0]);
}

const monochromatic = (wavelength: number): Vec3 =>
  [1, 2, 3].map((k) => {
    const value = interpolated(MONOCHROMATIC_KNOTS, wavelength, k) * interpolated(ENDS, wavelength, 1);
    return value ** (1 / CHANNEL_POWER);
  }) as unknown as Vec3;

/**
 * A colour as two wavelengths, which are shifted: the method of Zhu, Liu and Xia 2024 (docs/physics.md §14), for colours up to 1. Brighter light is
 * divided by its largest channel before, and multiplied by it after. It is no identity at D = 1, where renderers leave colours as they are.
 * @example
 * twoWavelengthShift([1, 0, 0], 645 / 510, 1); // [0, 1, 0]
 */
export function twoWavelengthShift(rgb: Vec3, D: number, mix: number): Vec3 {
  const most = Math.max(...rgb);
  if (!(most > 0)) return [0, 0, 0];
  const stretch = D ** -mix;
  const [first, second] = twoWavelengths(rgb.map((x) => (Math.max(x, 0) / most) ** CHANNEL_POWER) as unknown as Vec3);
  const [a, b] = [monochromatic(first[0] * stretch), monochromatic(second[0] * stretch)];
  return [0, 1, 2].map((k) => most * (first[1] * a[k]! + second[1] * b[k]!)) as unknown as Vec3;
}

type Line = readonly [wavelength: number, intensity: number];

/** The wavelengths [nm] of a colour whose largest channel is 1, and their intensities. */
function twoWavelengths([r, g, b]: Vec3): readonly [Line, Line] {
  if (r >= 1)
    return b <= g
      ? [
          [490, b],
          [645 - 65 * (g - b), 1],
        ]
      : [
          [645, 1],
          [440 + (50 * g) / b, b],
        ];
  if (g >= 1)
    return [
      [645, r],
      [510 - 20 * b, 1],
    ];
  const violet = 440 - 60 * r;
  return [
    [violet, 1 / (violet < 420 ? interpolated(ENDS, violet, 1) : 1)],
    [510, g],
  ];
}

/** Where the response of a primary's channel begins, the three primaries blue, green, red, and where it ends [nm]. */
export const PRIMARY_KNOTS = [379, 464, 549, 611, 673] as const;

/**
 * Each primary as one wavelength, which is shifted and seen by channels that fall linearly to the next primary, after the texture-based method of Mantiuk et
 * al. 2004 (docs/physics.md §14), which shifts components one by one. Identity at D = 1.
 * @example
 * primaryShift([0, 1, 0], 549 / 464, 1); // [0, 0, 1]
 */
export function primaryShift(rgb: Vec3, D: number, mix: number): Vec3 {
  const stretch = D ** -mix;
  const [, blue, green, red] = PRIMARY_KNOTS;
  const seen = ([red, green, blue] as const).map((at) => at * stretch);
  const channel = (k: number): number => rgb.reduce((sum, x, j) => sum + x * response(k, seen[j]!), 0);
  return [channel(3), channel(2), channel(1)];
}

/** A hat over its neighbours. */
function response(knot: number, wavelength: number): number {
  const [from, at, to] = [PRIMARY_KNOTS[knot - 1]!, PRIMARY_KNOTS[knot]!, PRIMARY_KNOTS[knot + 1]!];
  return Math.max(0, Math.min((wavelength - from) / (at - from), (to - wavelength) / (to - at)));
}
