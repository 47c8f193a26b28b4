import { joinedBytes } from '../../files/joinedBytes.ts';
import { Ditherer } from './dither.ts';
import { lzwBlocks } from './lzw.ts';
import { addPixels, choosePalette, emptyHistogram, fadeHistogram, type Palette, paletteError } from './palette.ts';

/** Colours of a palette; one more index stands for what does not change. */
const PALETTE_SIZE = 255;
const UNCHANGED = 255;
/** Pixels that a palette is chosen from. */
const SAMPLED_PIXELS = 60_000;
/** Weight that earlier frames have in the choice of a palette, from frame to frame. */
const MEMORY = 0.8;
/** A palette is kept while its error is at most this times what it was, and a squared step of 8-bit colours. */
const [TOLERATED_GROWTH, TOLERATED_ERROR] = [1.5, 7];

/** Durations of frames [1/100 s] whose sums are as near as possible to those of an even rate. `i`: index of the frame. */
export const gifDelay = (i: number, fps: number): number =>
  Math.round((100 * (i + 1)) / fps) - Math.round((100 * i) / fps);

/**
 * Encodes a film as an animated GIF that repeats for ever. Each call returns the bytes to append, so that memory does not
 * grow with the film. A palette is kept as long as it fits the frames, and pixels that do not change are not stored.
 * Source: GIF89a specification, CompuServe 1990.
 */
export class GifEncoder {
  private readonly width: number;
  private readonly height: number;
  private readonly fps: number;
  private readonly histogram = emptyHistogram();
  private palette: { readonly colors: Palette; readonly error: number; readonly ditherer: Ditherer } | undefined;
  /** The palette of the first frame, which later ones need not repeat. */
  private firstColors: Palette | undefined;
  /** The shown picture, 0xBBGGRR; −1 before the first frame. */
  private readonly shown: Int32Array;
  private readonly indices: Uint8Array;
  private frames = 0;

  constructor({ width, height }: { readonly width: number; readonly height: number }, fps: number) {
    this.width = width;
    this.height = height;
    this.fps = fps;
    this.shown = new Int32Array(width * height).fill(-1);
    this.indices = new Uint8Array(width * height);
  }

  /** RGBA8, rows from the top; the pictures are opaque. */
  add(rgba: Uint8Array): Uint8Array {
    const { colors, ditherer } = this.fittingPalette(rgba);
    ditherer.map(rgba, this.width, this.indices);
    const box = this.keepUnchanged(colors);
    const delay = gifDelay(this.frames, this.fps);
    const begin = this.frames++ === 0 ? [header(this.width, this.height, colors)] : [];
    this.firstColors ??= colors;
    const ownTable = colors === this.firstColors ? [] : [colorTable(colors)];
    const image = lzwBlocks(cropped(this.indices, this.width, box));
    return joinedBytes([
      ...begin,
      graphicControl(delay),
      imageDescriptor(box, ownTable.length > 0),
      ...ownTable,
      image,
    ]);
  }

  /** The end of the file. */
  finish = (): Uint8Array => Uint8Array.of(0x3b);

  private fittingPalette(rgba: Uint8Array): NonNullable<GifEncoder['palette']> {
    const { histogram } = this;
    const stride = Math.max(1, Math.floor(rgba.length / 4 / SAMPLED_PIXELS));
    const frame = emptyHistogram();
    addPixels(frame, rgba, stride);
    fadeHistogram(histogram, MEMORY);
    addPixels(histogram, rgba, stride);
    const { palette } = this;
    if (palette && paletteError(palette.colors, frame) <= TOLERATED_GROWTH * palette.error + TOLERATED_ERROR)
      return palette;
    const colors = choosePalette(histogram, PALETTE_SIZE);
    this.palette = { colors, error: paletteError(colors, frame), ditherer: new Ditherer(colors) };
    return this.palette;
  }

  /** Marks pixels that are shown already; returns what encloses the others, at least one pixel. */
  private keepUnchanged(colors: Palette): Box {
    const { width, height, indices, shown } = this;
    const table = Int32Array.from(
      { length: colors.length / 3 },
      (_, i) => colors[3 * i] | (colors[3 * i + 1] << 8) | (colors[3 * i + 2] << 16),
    );
    let [left, top, right, bottom] = [width, height, -1, -1];
    for (let y = 0, i = 0; y < height; y++)
      for (let x = 0; x < width; x++, i++) {
        const color = table[indices[i]];
        if (color === shown[i]) {
          indices[i] = UNCHANGED;
          continue;
        }
        shown[i] = color;
        left = Math.min(left, x);
        right = Math.max(right, x);
        top = Math.min(top, y);
        bottom = y;
      }
    if (right < 0) return { left: 0, top: 0, width: 1, height: 1 };
    return { left, top, width: right - left + 1, height: bottom - top + 1 };
  }
}

interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

const u16 = (value: number): readonly [number, number] => [value & 255, value >> 8];
const ascii = (text: string): number[] => [...text].map((letter) => letter.charCodeAt(0));

/** Signature, screen with a table of 256 colours, and the extension that repeats the film for ever. */
const header = (width: number, height: number, colors: Palette): Uint8Array =>
  Uint8Array.from([
    ...ascii('GIF89a'),
    ...u16(width),
    ...u16(height),
    ...[0xf7, 0, 0],
    ...colorTable(colors),
    ...[0x21, 0xff, 11, ...ascii('NETSCAPE2.0'), 3, 1, ...u16(0), 0],
  ]);

/** The picture stays until the next; `delay` [1/100 s]. */
const graphicControl = (delay: number): Uint8Array =>
  Uint8Array.from([0x21, 0xf9, 4, (1 << 2) | 1, ...u16(delay), UNCHANGED, 0]);

/** `ownTable`: whether a table of 256 colours follows. */
const imageDescriptor = ({ left, top, width, height }: Box, ownTable: boolean): Uint8Array =>
  Uint8Array.from([0x2c, ...u16(left), ...u16(top), ...u16(width), ...u16(height), ownTable ? 0x87 : 0]);

function colorTable(colors: Palette): Uint8Array {
  const table = new Uint8Array(3 * 256);
  table.set(colors);
  return table;
}

function cropped(indices: Uint8Array, width: number, box: Box): Uint8Array {
  const out = new Uint8Array(box.width * box.height);
  for (let y = 0; y < box.height; y++) {
    const start = (box.top + y) * width + box.left;
    out.set(indices.subarray(start, start + box.width), y * box.width);
  }
  return out;
}
