import type { Rgb8 } from '../../spectrum/falseColor/colorMaps.ts';
import { BACKGROUND, FOREGROUND, textScale } from './colorBar.ts';
import { createCanvas, drawText, fillRect, type PixelCanvas, paste, textHeight } from './pixelCanvas.ts';

/** A sign and what it means. */
export interface SignRow {
  readonly text: string;
  readonly color: Rgb8;
  /** A line, or hatching that falls or rises to the right. */
  readonly style: 'line' | 'falling' | 'rising';
}

/** Width of a sign, period and breadth of its hatching, and the margin [dots]. */
const [SIGN, PERIOD, STROKE, MARGIN] = [14, 4, 2, 4];

/** Height that a legend of these rows adds to a picture of this width [px]: even, as video codecs require; 0 without rows. */
export const keyLegendHeight = (width: number, rows: readonly SignRow[]): number => {
  const size = textScale(width);
  return rows.length === 0 ? 0 : 2 * Math.ceil((MARGIN * size + rows.length * rowHeight(size)) / 2);
};

const rowHeight = (size: number): number => textHeight(size) + MARGIN * size;

/** A picture with a legend of signs below; the picture itself without rows. */
export function withKeyLegend(picture: PixelCanvas, rows: readonly SignRow[]): PixelCanvas {
  if (rows.length === 0) return picture;
  const { width, height } = picture;
  const size = textScale(width);
  const canvas = createCanvas(width, height + keyLegendHeight(width, rows), BACKGROUND);
  paste(canvas, picture, 0, 0);
  for (const [i, row] of rows.entries()) {
    const [x, y] = [MARGIN * size, height + MARGIN * size + i * rowHeight(size)];
    drawSign(canvas, row, x, y, size);
    drawText(canvas, row.text, x + (SIGN + MARGIN) * size, y, size, FOREGROUND);
  }
  return canvas;
}

/** As high as a letter; x0 and y0 of its top left corner. */
function drawSign(on: PixelCanvas, { color, style }: SignRow, x0: number, y0: number, size: number): void {
  const lines = textHeight(size) / size;
  for (let y = 0; y < lines; y++)
    for (let x = 0; x < SIGN; x++) {
      const middle = Math.abs(y - (lines - 1) / 2) < 1;
      const along = style === 'falling' ? x - y + lines * PERIOD : x + y;
      if (style === 'line' ? middle : along % PERIOD < STROKE)
        fillRect(on, x0 + x * size, y0 + y * size, size, size, color);
    }
}
