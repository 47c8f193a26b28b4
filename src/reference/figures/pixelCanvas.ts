import type { Rgb8 } from '../../spectrum/falseColor/colorMaps.ts';
import { GLYPH_HEIGHT, GLYPH_WIDTH, glyph } from './glyphs.ts';

/** A drawing surface: RGBA, 8 bits each, sRGB, rows from the top. */
export interface PixelCanvas {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array;
}

export function createCanvas(width: number, height: number, color: Rgb8): PixelCanvas {
  const canvas = { width, height, pixels: new Uint8Array(4 * width * height) };
  fillRect(canvas, 0, 0, width, height, color);
  return canvas;
}

export function fillRect(
  on: PixelCanvas,
  x0: number,
  y0: number,
  width: number,
  height: number,
  [r, g, b]: Rgb8,
): void {
  for (let y = Math.max(y0, 0); y < Math.min(y0 + height, on.height); y++)
    for (let x = Math.max(x0, 0); x < Math.min(x0 + width, on.width); x++)
      on.pixels.set([r, g, b, 255], 4 * (y * on.width + x));
}

/** Copies `source`, which must fit. */
export function paste(on: PixelCanvas, source: PixelCanvas, x0: number, y0: number): void {
  for (let y = 0; y < source.height; y++) {
    const row = source.pixels.subarray(4 * y * source.width, 4 * (y + 1) * source.width);
    on.pixels.set(row, 4 * ((y0 + y) * on.width + x0));
  }
}

/** Draws `text` with its top left corner at x0, y0, with `size` pixels per dot of a letter. */
export function drawText(on: PixelCanvas, text: string, x0: number, y0: number, size: number, color: Rgb8): void {
  [...text].forEach((letter, n) => {
    glyph(letter).forEach((row, y) => {
      for (let x = 0; x < GLYPH_WIDTH; x++) {
        if (!((row >> (GLYPH_WIDTH - 1 - x)) & 1)) continue;
        fillRect(on, x0 + (n * (GLYPH_WIDTH + 1) + x) * size, y0 + y * size, size, size, color);
      }
    });
  });
}

export const textWidth = (text: string, size: number): number => (text.length * (GLYPH_WIDTH + 1) - 1) * size;
export const textHeight = (size: number): number => GLYPH_HEIGHT * size;
