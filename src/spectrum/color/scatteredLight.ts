import { IDENTITY, invert } from '../../math/mat3.ts';
import { addScaled, dot, type Vec3, ZERO } from '../../math/vec3.ts';
import { DAYLIGHT, type SampledSpectrum } from '../sources/lightSpectrum.ts';
import { logPlanck } from '../sources/planck.ts';
import { colorOfSpectrum } from './observerColor.ts';

/** Wavelengths that are visible for shifts from 1/9 to 9 [m]. */
const [FIRST, LAST, STEP] = [40e-9, 7.5e-6, 5e-9];
const REFERENCE = 550e-9;

type Three<T> = readonly [mild: T, middle: T, deep: T];

/** Daylight times a factor of air, which is a function of (550 nm/λ)⁴. */
const throughAir = (left: (ratio: number) => number): SampledSpectrum => ({
  kind: 'sampled',
  first: FIRST,
  step: STEP,
  values: Array.from({ length: Math.round((LAST - FIRST) / STEP) + 1 }, (_, i) => {
    const wavelength = FIRST + i * STEP;
    const daylight = logPlanck(wavelength, DAYLIGHT.temperature) - logPlanck(REFERENCE, DAYLIGHT.temperature);
    return Math.exp(daylight) * left((wavelength / REFERENCE) ** -4);
  }),
});

/** Daylight scattered by air: a blackbody of 6504 K times λ⁻⁴. docs/physics.md §7.8; Rayleigh 1871, Phil. Mag. 41, 107. */
export const SCATTERED: SampledSpectrum = throughAir((ratio) => ratio);

/**
 * Daylight transmitted through scattering air, exp(−τ (550 nm/λ)⁴), at three optical depths τ at 550 nm: the light of
 * low suns and evening skies.
 */
export const REDDENED: Three<SampledSpectrum> = [
  throughAir((ratio) => Math.exp(-0.5 * ratio)),
  throughAir((ratio) => Math.exp(-1.4 * ratio)),
  throughAir((ratio) => Math.exp(-4 * ratio)),
];

/** Linear sRGB of `SCATTERED` at luminance 1, at rest. */
export const SCATTERED_COLOR: Vec3 = colorOfSpectrum(SCATTERED);

/**
 * Least squares: among the sums w (1, 1, 1) + s `SCATTERED_COLOR`, the nearest to a colour has s = `SCATTERED_PROJECTION` · colour.
 * Clear skies are such sums of haze and air to 3 %.
 */
export const SCATTERED_PROJECTION: Vec3 = projectionOnto(SCATTERED_COLOR);

function projectionOnto([r, g, b]: Vec3): Vec3 {
  const mean = (r + g + b) / 3;
  const apart: Vec3 = [r - mean, g - mean, b - mean];
  const scale = 1 / dot(apart, apart);
  return [apart[0] * scale, apart[1] * scale, apart[2] * scale];
}

/** Linear sRGB of `REDDENED` at luminance 1, at rest. */
export const REDDENED_COLORS: Three<Vec3> = [
  colorOfSpectrum(REDDENED[0]),
  colorOfSpectrum(REDDENED[1]),
  colorOfSpectrum(REDDENED[2]),
];

/** Luminance of the scattered part of a sky of linear sRGB `rgb`; the rest is a filter before daylight. 0 for a sky no bluer than white. */
export const scatteredShare = (rgb: Vec3): number => Math.max(dot(rgb, SCATTERED_PROJECTION), 0);

/** Decomposition of sky light: luminances of scattered and of reddened light, and a filter before daylight. */
export interface SkyParts {
  readonly scattered: number;
  readonly reddened: Three<number>;
  readonly rest: Vec3;
}

/** Rows that give the amounts of the lights `a` and `b` in a colour that is a sum of white, a and b. */
function sharesOf(a: Vec3, b: Vec3): readonly [a: Vec3, b: Vec3] {
  const inverse = invert([1, a[0], b[0], 1, a[1], b[1], 1, a[2], b[2]]) ?? IDENTITY;
  return [
    [inverse[3], inverse[4], inverse[5]],
    [inverse[6], inverse[7], inverse[8]],
  ];
}

const [MILD, MIDDLE, DEEP] = REDDENED_COLORS;
/** `sharesOf` for the pairs of lights used: for colours bluer than the line from white to the deepest red, and for two ranges of redder ones. */
export const DUSK_SHARES = {
  blue: sharesOf(SCATTERED_COLOR, DEEP),
  red: sharesOf(MIDDLE, DEEP),
  yellow: sharesOf(MILD, MIDDLE),
} as const;

/**
 * Decomposes the linear sRGB `rgb` of a sky. Day and dusk skies are sums of white, scattered and reddened light, which leave a grey filter. For other
 * colours the scattered and reddened part is reduced until the remaining filter is nowhere negative.
 */
export function skyParts(rgb: Vec3): SkyParts {
  const [blue, red, yellow] = [DUSK_SHARES.blue, DUSK_SHARES.red, DUSK_SHARES.yellow].map(([a, b]) => [
    Math.max(dot(a, rgb), 0),
    Math.max(dot(b, rgb), 0),
  ]);
  const ofRed = red[1] > 0 ? [0, 0, ...red] : [0, ...yellow, 0];
  const shares = blue[0] > 0 ? [blue[0], 0, 0, blue[1]] : ofRed;
  const sum = [SCATTERED_COLOR, ...REDDENED_COLORS].reduce((all, color, i) => addScaled(all, color, shares[i]), ZERO);
  const most = Math.min(1, ...sum.map((value, k) => rgb[k] / Math.max(value, rgb[k], MIN_LIGHT)));
  const [scattered, mild, middle, deep] = shares.map((share) => share * most);
  return { scattered, reddened: [mild, middle, deep], rest: addScaled(rgb, sum, -most) };
}

/** Smaller channels count as zero. */
const MIN_LIGHT = 1e-9;
