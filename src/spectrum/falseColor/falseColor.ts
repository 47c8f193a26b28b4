import { coolWarm, magma, type Rgb8, viridis } from './colorMaps.ts';
import { bandColor, REFERENCE_WAVELENGTH } from './spectralBands.ts';

/**
 * What colours can stand for instead of light. `doppler`: D, of the surface or of the sky behind it; `emission-time`: how long before the
 * observer's event what is seen happened [s]; `radiance`: luminance of the linear light, before exposure and tone curve; `band`: which
 * part of the emitted spectrum is seen, over the picture.
 */
export type FalseColorQuantity = 'doppler' | 'emission-time' | 'radiance' | 'band';
export const FALSE_COLOR_QUANTITIES: readonly FalseColorQuantity[] = ['doppler', 'emission-time', 'radiance', 'band'];

/** The values at both ends of the colours. */
export interface ValueRange {
  readonly from: number;
  readonly to: number;
}

/** A false-colour picture: of what, and between which values. */
export interface FalseColorScale extends ValueRange {
  readonly kind: FalseColorQuantity;
}

interface QuantityColors {
  readonly logarithmic: boolean;
  /** At a share 0 … 1 of the way between the ends. */
  readonly color: (part: number, scale: ValueRange) => Rgb8;
}

/** Where a pixel has no such value. */
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

/** Equal ratios, not equal differences, are equal steps of colour. */
export const isLogarithmic = (kind: FalseColorQuantity): boolean => QUANTITY_COLORS[kind].logarithmic;

/** What `value` is in terms in which equal steps are equal steps of colour. */
export const toScaleUnits = (kind: FalseColorQuantity, value: number): number =>
  QUANTITY_COLORS[kind].logarithmic ? Math.log2(Math.max(value, 1e-38)) : value;

/** How far along the colours a value lies: 0 … 1 between the ends. */
export function positionOnScale(kind: FalseColorQuantity, value: number, { from, to }: ValueRange): number {
  const start = toScaleUnits(kind, from);
  return (toScaleUnits(kind, value) - start) / (toScaleUnits(kind, to) - start);
}

/** The value at a part of the way. */
export function valueAtPosition(kind: FalseColorQuantity, part: number, { from, to }: ValueRange): number {
  const [start, end] = [toScaleUnits(kind, from), toScaleUnits(kind, to)];
  const at = start + part * (end - start);
  return QUANTITY_COLORS[kind].logarithmic ? 2 ** at : at;
}

export const colorAt = (kind: FalseColorQuantity, part: number, scale: ValueRange): Rgb8 =>
  QUANTITY_COLORS[kind].color(part, scale);

/** The colour of a value; not a number: that there is nothing. */
export const falseColor = ({ kind, ...scale }: FalseColorScale, value: number): Rgb8 =>
  Number.isNaN(value) ? NO_VALUE_COLOR : colorAt(kind, positionOnScale(kind, value, scale), scale);

/** How much of a tint is left in the dark: what a band's colour is laid over can be recognised, and the dark still tells its band. */
export const MIN_SHADE = 0.35;
export const shadeFactor = (gray: number): number => MIN_SHADE + (1 - MIN_SHADE) * gray;

/** Of equal width along the colours, as they are kept on a GPU and drawn in a legend. */
export function colorRamp(kind: FalseColorQuantity, scale: ValueRange, steps: number): Rgb8[] {
  return Array.from({ length: steps }, (_, i) => colorAt(kind, i / (steps - 1), scale));
}
