import { decodeSrgb } from '../../../../../spectrum/display/srgb.ts';

/** Encoding and primaries of a colour space that MaterialX converts to linear sRGB (its cmlib). */
interface ColorSpace {
  /** Value of a linear component. */
  readonly decode: (x: number) => number;
  /** To linear sRGB primaries, row by row; absent: they are those. */
  readonly matrix?: readonly number[];
}

const gamma =
  (exponent: number) =>
  (x: number): number =>
    Math.max(0, x) ** exponent;
const linear = (x: number): number => x;

const AP1 = [
  1.705050992658, -0.621792120657, -0.083258872001, -0.130256417507, 1.140804736575, -0.010548319068, -0.024003356805,
  -0.128968976065, 1.15297233287,
];
const ADOBE_RGB = [1.39835574, -0.398355744, 0, 0, 1, 0, 0, -0.0429289893, 1.04292899];
const DISPLAY_P3 = [
  1.22493029, -0.22492968, 0.00000006, -0.04205868, 1.04205894, -0.00000001, -0.01964128, -0.07864794, 1.09828925,
];

const COLOR_SPACES: ReadonlyMap<string, ColorSpace> = new Map<string, ColorSpace>([
  ['lin_rec709', { decode: linear }],
  ['lin_rec709_scene', { decode: linear }],
  ['srgb_texture', { decode: decodeSrgb }],
  ['srgb_rec709_scene', { decode: decodeSrgb }],
  ['g18_rec709', { decode: gamma(1.8) }],
  ['g18_rec709_scene', { decode: gamma(1.8) }],
  ['g22_rec709', { decode: gamma(2.2) }],
  ['g22_rec709_scene', { decode: gamma(2.2) }],
  ['rec709_display', { decode: gamma(2.4) }],
  ['acescg', { decode: linear, matrix: AP1 }],
  ['lin_ap1', { decode: linear, matrix: AP1 }],
  ['lin_ap1_scene', { decode: linear, matrix: AP1 }],
  ['g22_ap1', { decode: gamma(2.2), matrix: AP1 }],
  ['g22_ap1_scene', { decode: gamma(2.2), matrix: AP1 }],
  ['lin_adobergb', { decode: linear, matrix: ADOBE_RGB }],
  ['lin_adobergb_scene', { decode: linear, matrix: ADOBE_RGB }],
  ['adobergb', { decode: gamma(563 / 256), matrix: ADOBE_RGB }],
  ['g22_adobergb_scene', { decode: gamma(563 / 256), matrix: ADOBE_RGB }],
  ['lin_displayp3', { decode: linear, matrix: DISPLAY_P3 }],
  ['lin_p3d65_scene', { decode: linear, matrix: DISPLAY_P3 }],
  ['srgb_displayp3', { decode: decodeSrgb, matrix: DISPLAY_P3 }],
  ['srgb_p3d65_scene', { decode: decodeSrgb, matrix: DISPLAY_P3 }],
]);

/** Names of the spaces of plain numbers. */
const RAW = new Set(['', 'raw', 'data', 'none', 'utility_raw']);

/** What a texture in a space is stored as; undefined if it has to be converted. */
export function storedAs(space: string): 'srgb' | 'linear' | undefined {
  if (RAW.has(space)) return 'linear';
  const known = COLOR_SPACES.get(space);
  if (!known || known.matrix) return undefined;
  return known.decode === decodeSrgb ? 'srgb' : known.decode === linear ? 'linear' : undefined;
}

export const isColorSpace = (space: string): boolean => RAW.has(space) || COLOR_SPACES.has(space);

/** A colour in linear sRGB; further components, such as alpha, are kept. */
export function toLinear(space: string, color: readonly number[]): readonly number[] {
  const known = COLOR_SPACES.get(space);
  if (!known || (known.decode === linear && !known.matrix)) return color;
  const [r, g, b] = color.slice(0, 3).map(known.decode);
  const { matrix: m } = known;
  const rgb = m ? [0, 3, 6].map((k) => m[k] * r + m[k + 1] * g + m[k + 2] * b) : [r, g, b];
  return [...rgb, ...color.slice(3)];
}
