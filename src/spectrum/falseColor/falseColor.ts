import { coolWarm, magma, type Rgb8, viridis } from './colorMaps.ts';
import { bandColor, REFERENCE_WAVELENGTH } from './spectralBands.ts';

/**
 * The quantity that false colours show. `doppler`: D of the surface, or of the sky behind it; `emission-time`: emission time relative to the
 * observer's event [s]; `radiance`: luminance of the linear light, before exposure and tone curve; `band`: the part of the emitted spectrum
 * that is visible, as a tint over the picture.
 */
export type FalseColorQuantity = 'doppler' | 'emission-time' | 'radiance' | 'band';
export const FALSE_COLOR_QUANTITIES: readonly FalseColorQuantity[] = ['doppler', 'emission-time', 'radiance', 'band'];

/** The values at both ends of the colours. */
export interface ValueRange {
  /** The value at the first colour. */
  readonly from: number;
  /** The value at the last colour. */
  readonly to: number;
}

/** The quantity and the range of a false-colour picture. */
export interface FalseColorScale extends ValueRange {
  /** What is shown. */
  readonly kind: FalseColorQuantity;
}

interface QuantityColors {
  readonly logarithmic: boolean;
  /** The colour at the position 0 … 1 between the ends. */
  readonly color: (part: number, scale: ValueRange) => Rgb8;
}

/** The colour of pixels without a value. */
export const NO_VALUE_COLOR: Rgb8 = [44, 47, 52];

const QUANTITY_COLORS: Readonly<Record<FalseColorQuantity, QuantityColors>> = {
  doppler: { logarithmic: true, color: (part) => coolWarm(1 - part) },
  'emission-time': { logarithmic: false, color: viridis },
  radiance: { logarithmic: true, color: magma },
  band: {
    logarithmic: true,
    color: (part, scale) => bandColor(valueAtPosition('band', part, scale) / REFERENCE_WAVELENGTH),
  },
};

/** Whether equal ratios, not equal differences, are equal steps of colour. */
export const isLogarithmic = (kind: FalseColorQuantity): boolean => QUANTITY_COLORS[kind].logarithmic;

/** Maps a value to the scale's units, in which equal steps are equal steps of colour. */
export const toScaleUnits = (kind: FalseColorQuantity, value: number): number =>
  QUANTITY_COLORS[kind].logarithmic ? Math.log2(Math.max(value, 1e-38)) : value;

/** Position of a value on the scale: 0 … 1 between the ends. */
export function positionOnScale(kind: FalseColorQuantity, value: number, { from, to }: ValueRange): number {
  const start = toScaleUnits(kind, from);
  return (toScaleUnits(kind, value) - start) / (toScaleUnits(kind, to) - start);
}

/** The value at a position on the scale: inverse of `positionOnScale`. */
export function valueAtPosition(kind: FalseColorQuantity, part: number, { from, to }: ValueRange): number {
  const [start, end] = [toScaleUnits(kind, from), toScaleUnits(kind, to)];
  const at = start + part * (end - start);
  return QUANTITY_COLORS[kind].logarithmic ? 2 ** at : at;
}

export const colorAt = (kind: FalseColorQuantity, part: number, scale: ValueRange): Rgb8 =>
  QUANTITY_COLORS[kind].color(part, scale);

/** The colour of a value; NaN has `NO_VALUE_COLOR`. */
export const falseColor = ({ kind, ...scale }: FalseColorScale, value: number): Rgb8 =>
  Number.isNaN(value) ? NO_VALUE_COLOR : colorAt(kind, positionOnScale(kind, value, scale), scale);

/** Least brightness of a band's tint over dark pixels, so that the picture is recognizable and dark parts still show their band. */
export const MIN_SHADE = 0.35;
export const shadeFactor = (gray: number): number => MIN_SHADE + (1 - MIN_SHADE) * gray;

/** `steps` colours at equal steps of position, for GPU textures and legends. */
export function colorRamp(kind: FalseColorQuantity, scale: ValueRange, steps: number): Rgb8[] {
  return Array.from({ length: steps }, (_, i) => colorAt(kind, i / (steps - 1), scale));
}
