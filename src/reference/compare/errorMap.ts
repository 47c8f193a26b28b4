import { type Color, magma } from '../../spectrum/colorMaps.ts';
import { type Canvas, canvas, fill, paste, textHeight, textWidth, write } from './canvas.ts';

/** What the colours of an error map mean. */
export interface Legend {
  /** `FLIP`, `DISPLACEMENT (PX)` */
  readonly title: string;
  /** The error that has the brightest colour; larger ones have it too. */
  readonly max: number;
}

const GROUND: Color = [24, 24, 27];
const INK: Color = [228, 228, 231];
/** Where there is no error to tell: a grey that magma has not. */
const UNKNOWN: Color = [63, 63, 70];

/** Errors as colours, black none … light yellow `max`; not a number is grey. */
export function errorMap(errors: ArrayLike<number>, width: number, height: number, max: number): Canvas {
  const map = canvas(width, height, UNKNOWN);
  for (let i = 0; i < errors.length; i++) if (!Number.isNaN(errors[i])) map.pixels.set(magma(errors[i] / max), 4 * i);
  return map;
}

/** Pictures of one size side by side, each under its caption where it has one, over a bar that tells what the colours of the last one mean. */
export function sheet(
  pictures: readonly { readonly picture: Canvas; readonly caption?: string }[],
  legend: Legend,
): Canvas {
  const [{ picture: first }] = pictures;
  const size = first.width >= 480 ? 2 : 1;
  const gap = 2 * size;
  const line = textHeight(size) + 6 * size;
  const top = pictures.some(({ caption }) => caption) ? line : 0;
  const column = Math.max(first.width, Math.ceil(leastWidth(legend, size) / pictures.length));
  const wide = column * pictures.length + gap * (pictures.length - 1);
  const bar = legendBar(wide, size, legend);
  const made = canvas(wide, top + first.height + bar.height, GROUND);
  pictures.forEach(({ picture, caption = '' }, n) => {
    const x = n * (column + gap);
    write(made, caption, x + 3 * size, 3 * size, size, INK);
    paste(made, picture, x, top);
  });
  paste(made, bar, 0, top + first.height);
  return made;
}

/** The title, the colours from none to the largest, and numbers under them. */
function legendBar(width: number, size: number, { title, max }: Legend): Canvas {
  const [margin, thick, line] = [4 * size, 6 * size, textHeight(size)];
  const bar = canvas(width, 3 * margin + 2 * line + thick + 2 * size, GROUND);
  write(bar, title, margin, margin, size, INK);
  const [length, top] = [width - 2 * margin, 2 * margin + line];
  for (let x = 0; x < length; x++) fill(bar, margin + x, top, 1, thick, magma(x / (length - 1)));
  for (const part of ticks(length, size, max)) {
    const label = number(part * max);
    const room = length - textWidth(label, size);
    const x = Math.min(Math.max(part * length - textWidth(label, size) / 2, 0), room);
    write(bar, label, margin + Math.round(x), top + thick + 2 * size, size, INK);
  }
  return bar;
}

const PARTS = [0, 0.25, 0.5, 0.75, 1];
/** As many as have room. */
function ticks(length: number, size: number, max: number): number[] {
  const widest = Math.max(...PARTS.map((part) => textWidth(number(part * max), size)));
  return length > 1.5 * PARTS.length * widest ? PARTS : [0, 1];
}

const leastWidth = ({ title, max }: Legend, size: number): number =>
  8 * size + Math.max(textWidth(title, size), 3 * textWidth(number(max), size));

const number = (value: number): string => String(Number(value.toPrecision(3)));
