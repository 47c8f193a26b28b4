import type { LegendTexts } from './legendTexts.ts';

/** Texts under the bar while the crosshair is on: value, object, and position on the bar. */
export interface CrosshairTexts {
  readonly value: string;
  readonly of: string;
  readonly part: number | undefined;
}

/** Position of the page's legend on the picture [CSS px], and its colours. */
export interface LegendStyle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly ground: string;
  readonly ink: string;
  readonly line: string;
  readonly font: string;
}

/** As in legend.css [px]. */
const PADDING = { x: 13, y: 9 } as const;
const BAR_HEIGHT = 12;
const ROW_HEIGHT = 18;
/** Height of the buttons beside it, and the gap below. */
const TITLE_HEIGHT = 26;
const SWATCH_SIZE = 9;
const TEXT_SIZE = 11;
const TITLE_SIZE = 12;

type Context = CanvasRenderingContext2D;

/** Style of the displayed legend. `element`: the legend, `picture`: the element below it. */
export function legendStyleOf(element: HTMLElement, picture: HTMLElement): LegendStyle {
  const [box, under] = [element.getBoundingClientRect(), picture.getBoundingClientRect()];
  const { backgroundColor, color, borderTopColor, fontFamily } = getComputedStyle(element);
  return {
    x: box.x - under.x,
    y: box.y - under.y,
    width: box.width,
    ground: backgroundColor,
    ink: color,
    line: borderTopColor,
    font: fontFamily,
  };
}

/**
 * Draws a legend into a picture, in a context scaled to CSS pixels: without buttons, and with a value only for the
 * crosshair.
 */
export function drawLegend(context: Context, words: LegendTexts, look: LegendStyle, crosshair?: CrosshairTexts): void {
  const [left, width] = [look.x + PADDING.x, look.width - 2 * PADDING.x];
  context.textBaseline = 'middle';
  const font = (size: number, weight = 400): void => {
    context.font = `${weight} ${size}px ${look.font}`;
  };
  font(TITLE_SIZE, 600);
  const titles = wrapText(context, words.title, width);
  font(TEXT_SIZE);
  const bands = wrapBands(context, words.bands, width);
  const titleRoom = TITLE_HEIGHT + (titles.length - 1) * ROW_HEIGHT;
  const rows = 1 + bands.length + (crosshair ? 1 : 0);
  drawFrame(context, look, 2 * PADDING.y + titleRoom + BAR_HEIGHT + rows * ROW_HEIGHT);

  let y = look.y + PADDING.y;
  const nextRow = (): number => {
    y += ROW_HEIGHT;
    return y - ROW_HEIGHT / 2;
  };
  context.fillStyle = look.ink;
  font(TITLE_SIZE, 600);
  for (const title of titles) context.fillText(title, left, nextRow());
  y = look.y + PADDING.y + titleRoom;
  drawBar(context, words.stops, look.line, [left, y, width, BAR_HEIGHT]);
  if (crosshair?.part !== undefined) drawMarker(context, left + crosshair.part * width, y);
  y += BAR_HEIGHT;
  context.fillStyle = look.ink;
  font(TEXT_SIZE);
  const tickRow = nextRow();
  for (const { part, text } of words.ticks) {
    const wide = context.measureText(text).width;
    context.fillText(text, left + clampTo(part * width - wide / 2, 0, width - wide), tickRow);
  }
  for (const row of bands) drawBands(context, row, left, nextRow(), look);
  if (!crosshair) return;
  const valueRow = nextRow();
  font(TEXT_SIZE, 700);
  context.fillText(crosshair.value, left, valueRow);
  const taken = context.measureText(crosshair.value).width + 8;
  font(TEXT_SIZE);
  const of = truncateStart(context, crosshair.of, width - taken);
  context.fillText(of, left + width - context.measureText(of).width, valueRow);
}

const clampTo = (value: number, from: number, to: number): number =>
  Math.min(Math.max(value, from), Math.max(from, to));

/** Ground and border of a legend. */
export function drawFrame(context: Context, { x, y, width, ground, line }: LegendStyle, height: number): void {
  context.beginPath();
  context.roundRect(x + 0.5, y + 0.5, width - 1, height - 1, 4);
  context.fillStyle = ground;
  context.fill();
  context.strokeStyle = line;
  context.lineWidth = 1;
  context.stroke();
}

/** [CSS px] */
export type Rectangle = readonly [x: number, y: number, width: number, height: number];

function drawBar(context: Context, stops: readonly string[], line: string, box: Rectangle): void {
  const [x, , width] = box;
  const gradient = context.createLinearGradient(x, 0, x + width, 0);
  for (const [i, color] of stops.entries()) gradient.addColorStop(i / (stops.length - 1), color);
  context.fillStyle = gradient;
  context.fillRect(...box);
  context.strokeStyle = line;
  context.strokeRect(box[0] + 0.5, box[1] + 0.5, box[2] - 1, box[3] - 1);
}

function drawMarker(context: Context, x: number, y: number): void {
  context.fillStyle = '#fff';
  context.fillRect(x - 1.5, y - 4, 3, BAR_HEIGHT + 8);
  context.fillStyle = '#000';
  context.fillRect(x - 0.5, y - 3, 1, BAR_HEIGHT + 6);
}

/** Draws a crosshair at the center of a picture of this size. */
export function drawCrosshair(context: Context, width: number, height: number): void {
  const [x, y] = [width / 2, height / 2];
  context.fillStyle = '#000';
  context.fillRect(x - 11.5, y - 1.5, 23, 3);
  context.fillRect(x - 1.5, y - 11.5, 3, 23);
  context.fillStyle = '#fff';
  context.fillRect(x - 10.5, y - 0.5, 21, 1);
  context.fillRect(x - 0.5, y - 10.5, 1, 21);
}

type Band = LegendTexts['bands'][number];

function drawBands(context: Context, row: readonly Band[], left: number, y: number, { ink, line }: LegendStyle): void {
  let x = left;
  for (const { name, color } of row) {
    context.fillStyle = color;
    context.fillRect(x, y - SWATCH_SIZE / 2, SWATCH_SIZE, SWATCH_SIZE);
    context.strokeStyle = line;
    context.strokeRect(x + 0.5, y - SWATCH_SIZE / 2 + 0.5, SWATCH_SIZE - 1, SWATCH_SIZE - 1);
    context.fillStyle = ink;
    context.fillText(name, x + SWATCH_SIZE + 5, y);
    x += bandWidth(context, name);
  }
}

const bandWidth = (context: Context, name: string): number => SWATCH_SIZE + 5 + context.measureText(name).width + 10;

function wrapBands(context: Context, bands: readonly Band[], width: number): Band[][] {
  const rows: Band[][] = [];
  let room = 0;
  for (const band of bands) {
    const wide = bandWidth(context, band.name);
    if (rows.length === 0 || wide - 10 > room) {
      rows.push([]);
      room = width;
    }
    rows.at(-1)!.push(band);
    room -= wide;
  }
  return rows;
}

/** Wraps at spaces into lines no wider than `width`. */
function wrapText(context: Context, text: string, width: number): string[] {
  const lines: string[] = [];
  for (const word of text.split(' ')) {
    const longer = lines.length > 0 ? `${lines.at(-1)} ${word}` : word;
    if (lines.length > 0 && context.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

/** Truncates at the start to fit. */
function truncateStart(context: Context, text: string, width: number): string {
  let shown = text;
  for (let i = 1; i < text.length && context.measureText(shown).width > width; i++) shown = `…${text.slice(i)}`;
  return shown;
}
