import { type Color, coolWarm, magma, viridis } from './colorMaps.ts';
import { bandColor, MIDDLE } from './spectralBands.ts';

/**
 * What colours can stand for instead of light. `doppler`: D, of the surface or of the sky behind it; `emission-time`: how long before the
 * observer's event what is seen happened [s]; `radiance`: luminance of the linear light, before exposure and tone curve; `band`: which
 * part of the emitted spectrum is seen, over the picture.
 */
export type FalseColor = 'doppler' | 'emission-time' | 'radiance' | 'band';
export const FALSE_COLORS: readonly FalseColor[] = ['doppler', 'emission-time', 'radiance', 'band'];

/** The values at both ends of the colours. */
export interface Scale {
  readonly from: number;
  readonly to: number;
}

/** A false-colour picture: of what, and between which values. */
export interface FalseColors extends Scale {
  readonly kind: FalseColor;
}

interface Kind {
  readonly logarithmic: boolean;
  /** At a share 0 … 1 of the way between the ends. */
  readonly color: (part: number, scale: Scale) => Color;
}

/** Where a pixel has no such value. */
export const NOTHING: Color = [44, 47, 52];

const KINDS: Readonly<Record<FalseColor, Kind>> = {
  doppler: { logarithmic: true, color: (part) => coolWarm(1 - part) },
  'emission-time': { logarithmic: false, color: viridis },
  radiance: { logarithmic: true, color: magma },
  band: { logarithmic: true, color: (part, scale) => bandColor(valueAt('band', part, scale) / MIDDLE) },
};

/** Equal ratios, not equal differences, are equal steps of colour. */
export const isLogarithmic = (kind: FalseColor): boolean => KINDS[kind].logarithmic;

/** What `value` is in terms in which equal steps are equal steps of colour. */
export const stepped = (kind: FalseColor, value: number): number =>
  KINDS[kind].logarithmic ? Math.log2(Math.max(value, 1e-38)) : value;

/** How far along the colours a value lies: 0 … 1 between the ends. */
export function partOf(kind: FalseColor, value: number, { from, to }: Scale): number {
  const start = stepped(kind, from);
  return (stepped(kind, value) - start) / (stepped(kind, to) - start);
}

/** The value at a part of the way. */
export function valueAt(kind: FalseColor, part: number, { from, to }: Scale): number {
  const [start, end] = [stepped(kind, from), stepped(kind, to)];
  const at = start + part * (end - start);
  return KINDS[kind].logarithmic ? 2 ** at : at;
}

export const colorAt = (kind: FalseColor, part: number, scale: Scale): Color => KINDS[kind].color(part, scale);

/** The colour of a value; not a number: that there is nothing. */
export const falseColor = ({ kind, ...scale }: FalseColors, value: number): Color =>
  Number.isNaN(value) ? NOTHING : colorAt(kind, partOf(kind, value, scale), scale);

/** How much of a tint is left in the dark: what a band's colour is laid over can be recognised, and the dark still tells its band. */
export const LEAST_SHADE = 0.35;
export const shaded = (grey: number): number => LEAST_SHADE + (1 - LEAST_SHADE) * grey;

/** Of equal width along the colours, as they are kept on a GPU and drawn in a legend. */
export function colorRow(kind: FalseColor, scale: Scale, steps: number): Color[] {
  return Array.from({ length: steps }, (_, i) => colorAt(kind, i / (steps - 1), scale));
}
