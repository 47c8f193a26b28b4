import type { Rgb8 } from '../../spectrum/falseColor/colorMaps.ts';
import { createCanvas, drawText, fillRect, type PixelCanvas, textHeight, textWidth } from './pixelCanvas.ts';

export const BACKGROUND: Rgb8 = [24, 24, 27];
export const FOREGROUND: Rgb8 = [228, 228, 231];

/** Least gap between two labels [dots]; wider than between two letters. */
const LABEL_GAP = 6;

export interface TickLabel {
  readonly part: number;
  readonly text: string;
}

/** A legend drawn under a picture. */
export interface ColorBar {
  readonly title: string;
  /** The colour at a fraction 0 … 1 of the bar's length. */
  readonly color: (part: number) => Rgb8;
  /** Rows of labels under the bar, each centred at its `part` of the length; labels that would overlap earlier ones are omitted. */
  readonly rows: readonly (readonly TickLabel[])[];
}

/** Draws title, colours and labels; `size`: pixels per dot of a letter. The height is even, as video codecs require. */
export function drawColorBar(width: number, size: number, { title, color, rows }: ColorBar): PixelCanvas {
  const [margin, thick, line] = [4 * size, 6 * size, textHeight(size)];
  const bar = createCanvas(width, colorBarHeight(size, rows.length), BACKGROUND);
  drawText(bar, title, margin, margin, size, FOREGROUND);
  const [length, top] = [width - 2 * margin, 2 * margin + line];
  for (let x = 0; x < length; x++) fillRect(bar, margin + x, top, 1, thick, color(x / (length - 1)));
  for (const [row, labels] of rows.entries()) {
    const y = top + thick + 2 * size + row * rowHeight(size);
    for (const { x, text } of placeLabels(labels, length, size)) drawText(bar, text, margin + x, y, size, FOREGROUND);
  }
  return bar;
}

function placeLabels(
  labels: readonly TickLabel[],
  length: number,
  size: number,
): { readonly x: number; readonly text: string }[] {
  const taken: { x: number; end: number; text: string }[] = [];
  for (const { part, text } of labels) {
    const labelWidth = textWidth(text, size);
    const x = Math.round(Math.min(Math.max(part * length - labelWidth / 2, 0), length - labelWidth));
    if (taken.some((other) => x < other.end + LABEL_GAP * size && x + labelWidth > other.x - LABEL_GAP * size))
      continue;
    taken.push({ x, end: x + labelWidth, text });
  }
  return taken;
}

const rowHeight = (size: number): number => textHeight(size) + 2 * size;

export const colorBarHeight = (size: number, rows: number): number =>
  2 * Math.ceil((18 * size + textHeight(size) + rows * rowHeight(size)) / 2);
/** Pixels per dot of a letter, legible in a picture of this width. */
export const textScale = (width: number): number => (width >= 480 ? 2 : 1);
