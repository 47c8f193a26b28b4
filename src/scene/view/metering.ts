import { isPanoramic, type Lens, pixelSolidAngle } from './lenses/lenses.ts';
import type { PictureSize } from './pictureSize.ts';
import { type PixelRect, rectContains } from './pictureViews.ts';

/** Pictures are metered at the centres of this many equal cells across and down. */
export const METER_CELLS = 64;

/** Readings at the cells, rows from the top; NaN where undefined. */
export interface LightMeterReadings {
  /** Luminance of the linear light before exposure. */
  readonly luminance: Float32Array;
  /** D of the surface, or of the sky. */
  readonly doppler: Float32Array;
  /** World time of the shown event minus the observer's [s]; negative if its light was delayed. */
  readonly time: Float32Array;
}

/** What is read: `luminance` alone costs least, and leaves the others undefined. */
export type MeteredQuantities = 'all' | 'luminance';

/** The pixel at cell `i` along a side of `size` pixels. */
export const meterPixel = (i: number, size: number): number => Math.floor(((i + 0.5) / METER_CELLS) * size);

/** Relative luminance of linear sRGB; that of white is 1. */
export const relativeLuminance = (r: number, g: number, b: number): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Merges the readings of a picture's views, each cell by the nearest reading; NaN outside all views. */
export function mergeReadings(
  parts: readonly { readonly rect: PixelRect; readonly readings: LightMeterReadings }[],
  size: PictureSize,
): LightMeterReadings {
  const [only] = parts;
  const { width, height } = size;
  const isWhole = ({ x, y, ...rect }: PixelRect) =>
    x === 0 && y === 0 && rect.width === width && rect.height === height;
  if (parts.length === 1 && isWhole(only.rect)) return only.readings;
  const cellOf = (pixel: number, side: number): number => Math.floor(((pixel + 0.5) / side) * METER_CELLS);
  const sources = Array.from({ length: METER_CELLS * METER_CELLS }, (_, i) => {
    const [px, py] = [meterPixel(i % METER_CELLS, width), meterPixel(Math.floor(i / METER_CELLS), height)];
    const found = parts.find(({ rect }) => rectContains(rect, px, py));
    if (!found) return undefined;
    const { rect, readings } = found;
    return { readings, cell: cellOf(py - rect.y, rect.height) * METER_CELLS + cellOf(px - rect.x, rect.width) };
  });
  const merged = (channel: keyof LightMeterReadings): Float32Array =>
    Float32Array.from(sources, (source) => (source ? source.readings[channel][source.cell] : Number.NaN));
  return { luminance: merged('luminance'), doppler: merged('doppler'), time: merged('time') };
}

/** Readings of a picture of this size, with NaN where its lens shows nothing. */
export function readingsInPicture(readings: LightMeterReadings, lens: Lens, size: PictureSize): LightMeterReadings {
  if (!isPanoramic(lens)) return readings;
  const isShown = (cell: number): boolean =>
    pixelSolidAngle(
      lens,
      meterPixel(cell % METER_CELLS, size.width) + 0.5,
      meterPixel(Math.floor(cell / METER_CELLS), size.height) + 0.5,
      size,
    ) > 0;
  const shown = (values: Float32Array): Float32Array => values.map((value, i) => (isShown(i) ? value : Number.NaN));
  return { luminance: shown(readings.luminance), doppler: shown(readings.doppler), time: shown(readings.time) };
}
