import { dot, type Vec3 } from '../../math/vec3.ts';

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

/** Where a spectrum of three channels has its corners: ultraviolet, blue, green, red and infrared [nm]. */
export const SPECTRUM_CORNERS = [340, 460, 520, 700, 1000] as const;
/** Its values there, as shares of red, green and blue. */
export const CORNER_SHARES: readonly Vec3[] = [
  [1 / 8, 1 / 4, 1 / 2],
  [0, 0, 1],
  [0, 1, 0],
  [1, 0, 0],
  [1 / 2, 1 / 4, 1 / 8],
];

/**
 * A colour as a spectrum S(λ) that runs straight between its three channels and two more, made up of them, in the infrared and the ultraviolet; beyond those
 * it falls as λ and 1/λ. A channel shows S(Dλ). The method of the texture-based paper by Mantiuk et al. 2004, after the ray tracer Backlight by A. Searle
 * (docs/physics.md §14). Identity at D = 1.
 * @example
 * linearSpectrumShift([1, 0, 0], 700 / 520, 1); // [0.596 …, 1, 0.551 …]
 */
export function linearSpectrumShift(rgb: Vec3, D: number, mix: number): Vec3 {
  const stretch = D ** mix;
  const values = CORNER_SHARES.map((shares) => dot(shares, rgb));
  const corners = SPECTRUM_CORNERS.map((corner, i) => [corner, values[i]!] as const);
  const [ultraviolet, blue, green, red, infrared] = SPECTRUM_CORNERS;
  const spectrum = (wavelength: number): number => {
    if (wavelength < ultraviolet) return (values[0]! * wavelength) / ultraviolet;
    if (wavelength >= infrared) return (values[4]! * infrared) / wavelength;
    return interpolated(corners, wavelength, 1);
  };
  return [spectrum(red * stretch), spectrum(green * stretch), spectrum(blue * stretch)];
}
