/** A picture is measured at so many places across, and as many down: the middles of equal cells. */
export const METER_CELLS = 64;

/** What is found at the places, rows from the top; not a number where there is nothing of the kind. */
export interface LightMeterReadings {
  /** Of the linear light, before any exposure. */
  readonly luminance: Float32Array;
  /** D of the surface, or of the sky. */
  readonly doppler: Float32Array;
  /** World time of the event that is seen, after the observer's [s]; negative where light was on its way. */
  readonly time: Float32Array;
}

/** The pixel under place `i` along a side of `size` pixels. */
export const meterPixel = (i: number, size: number): number => Math.floor(((i + 0.5) / METER_CELLS) * size);

/** Of linear sRGB: Y of white is 1. */
export const relativeLuminance = (r: number, g: number, b: number): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;
