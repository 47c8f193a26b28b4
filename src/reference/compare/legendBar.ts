import type { Color } from '../../spectrum/colorMaps.ts';
import { type Canvas, canvas, fill, textHeight, textWidth, write } from './canvas.ts';

export const GROUND: Color = [24, 24, 27];
export const INK: Color = [228, 228, 231];

/** Between two labels [dots]: more than between two letters. */
const GAP = 6;

export interface Label {
  readonly part: number;
  readonly text: string;
}

/** What is drawn under a picture to tell what its colours mean. */
export interface LegendBar {
  readonly title: string;
  /** At a part 0 … 1 of its length. */
  readonly color: (part: number) => Color;
  /** Rows of numbers or words under it, each in the middle of its place; what has no room beside those before it is left out. */
  readonly rows: readonly (readonly Label[])[];
}

/** The title, the colours, and what they mean under them; `size`: pixels of each dot of a letter. Its height is even, as films ask for. */
export function legendBar(width: number, size: number, { title, color, rows }: LegendBar): Canvas {
  const [margin, thick, line] = [4 * size, 6 * size, textHeight(size)];
  const bar = canvas(width, legendHeight(size, rows.length), GROUND);
  write(bar, title, margin, margin, size, INK);
  const [length, top] = [width - 2 * margin, 2 * margin + line];
  for (let x = 0; x < length; x++) fill(bar, margin + x, top, 1, thick, color(x / (length - 1)));
  for (const [row, labels] of rows.entries()) {
    const y = top + thick + 2 * size + row * rowHeight(size);
    for (const { x, text } of placed(labels, length, size)) write(bar, text, margin + x, y, size, INK);
  }
  return bar;
}

function placed(
  labels: readonly Label[],
  length: number,
  size: number,
): { readonly x: number; readonly text: string }[] {
  const taken: { x: number; end: number; text: string }[] = [];
  for (const { part, text } of labels) {
    const wide = textWidth(text, size);
    const x = Math.round(Math.min(Math.max(part * length - wide / 2, 0), length - wide));
    if (taken.some((other) => x < other.end + GAP * size && x + wide > other.x - GAP * size)) continue;
    taken.push({ x, end: x + wide, text });
  }
  return taken;
}

const rowHeight = (size: number): number => textHeight(size) + 2 * size;

export const legendHeight = (size: number, rows: number): number =>
  2 * Math.ceil((18 * size + textHeight(size) + rows * rowHeight(size)) / 2);
/** Letters that can be read in a picture of this width. */
export const letterSize = (width: number): number => (width >= 480 ? 2 : 1);
