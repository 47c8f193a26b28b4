import { magma, type Rgb8 } from '../../spectrum/falseColor/colorMaps.ts';
import { BACKGROUND, drawColorBar, FOREGROUND, textScale } from './colorBar.ts';
import { createCanvas, drawText, type PixelCanvas, paste, textHeight, textWidth } from './pixelCanvas.ts';

/** Title and range of an error map's colours. */
export interface ErrorLegend {
  /** `FLIP`, `DISPLACEMENT (PX)` */
  readonly title: string;
  /** The error with the brightest colour; larger ones are clamped to it. */
  readonly max: number;
}

/** For pixels without an error: a grey that is not in magma. */
const UNKNOWN_COLOR: Rgb8 = [63, 63, 70];

/** Errors as colours: black 0 … light yellow `max`; NaN is grey. */
export function errorMap(errors: ArrayLike<number>, width: number, height: number, max: number): PixelCanvas {
  const map = createCanvas(width, height, UNKNOWN_COLOR);
  for (let i = 0; i < errors.length; i++) if (!Number.isNaN(errors[i])) map.pixels.set(magma(errors[i] / max), 4 * i);
  return map;
}

/** Pictures of one size side by side, under their captions, with a colour bar of `legend` below. */
export function comparisonSheet(
  pictures: readonly { readonly picture: PixelCanvas; readonly caption?: string }[],
  legend: ErrorLegend,
): PixelCanvas {
  const [{ picture: first }] = pictures;
  const size = textScale(first.width);
  const gap = 2 * size;
  const line = textHeight(size) + 6 * size;
  const top = pictures.some(({ caption }) => caption) ? line : 0;
  const column = Math.max(first.width, Math.ceil(minWidth(legend, size) / pictures.length));
  const wide = column * pictures.length + gap * (pictures.length - 1);
  const bar = errorBar(wide, size, legend);
  const sheet = createCanvas(wide, top + first.height + bar.height, BACKGROUND);
  pictures.forEach(({ picture, caption = '' }, n) => {
    const x = n * (column + gap);
    drawText(sheet, caption, x + 3 * size, 3 * size, size, FOREGROUND);
    paste(sheet, picture, x, top);
  });
  paste(sheet, bar, 0, top + first.height);
  return sheet;
}

/** A colour bar from 0 to `max`. */
const errorBar = (width: number, size: number, { title, max }: ErrorLegend): PixelCanvas =>
  drawColorBar(width, size, {
    title,
    color: magma,
    rows: [ticks(width - 8 * size, size, max).map((part) => ({ part, text: number(part * max) }))],
  });

const PARTS = [0, 0.25, 0.5, 0.75, 1];
/** All `PARTS` if they fit, otherwise only both ends. */
function ticks(length: number, size: number, max: number): number[] {
  const widest = Math.max(...PARTS.map((part) => textWidth(number(part * max), size)));
  return length > 1.5 * PARTS.length * widest ? PARTS : [0, 1];
}

const minWidth = ({ title, max }: ErrorLegend, size: number): number =>
  8 * size + Math.max(textWidth(title, size), 3 * textWidth(number(max), size));

const number = (value: number): string => String(Number(value.toPrecision(3)));
