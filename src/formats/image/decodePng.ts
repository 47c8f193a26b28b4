import { unzlibSync } from 'fflate';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { crc32 } from '../files/crc32.ts';
import { joinedBytes } from '../files/joinedBytes.ts';

/**
 * PNG pixels (W3C Portable Network Graphics, third edition): every colour type and depth, interlaced or not, as RGBA8
 * with rows from the top. 16-bit values are rounded; colour profiles and gamma are left out, as browsers' textures do.
 * Memory is bounded by the size in the header, whatever the compressed data hold. Throws an Error where it cannot.
 */
export function decodePngPixels(bytes: Uint8Array): Uint8Array {
  const chunks = readChunks(bytes);
  const format = readFormat(chunks);
  const passes = format.isInterlaced ? ADAM7 : [{ x: 0, y: 0, dx: 1, dy: 1 }];
  const sizes = passes.map((p) => [Math.ceil((format.width - p.x) / p.dx), Math.ceil((format.height - p.y) / p.dy)]);
  const rowBytes = (width: number): number => Math.ceil((width * format.channels * format.depth) / 8);
  const rawSizes = sizes.map(([w, h]) => (w > 0 && h > 0 ? h * (1 + rowBytes(w)) : 0));
  const total = rawSizes.reduce((a, b) => a + b, 0);
  const raw = unzlibSync(joinedBytes(chunks.data), { out: new Uint8Array(total) });
  if (raw.length !== total) throw new MessageError(msg`${raw.length} of ${total} bytes of pixels`);
  const out = new Uint8Array(format.width * format.height * 4);
  const write = pixelWriter(format, out);
  let at = 0;
  for (const [i, { x, y, dx, dy }] of passes.entries()) {
    const [w, h] = sizes[i];
    if (rawSizes[i] === 0) continue;
    const size = rowBytes(w);
    unfilter(raw.subarray(at, at + rawSizes[i]), size, Math.max(1, (format.channels * format.depth) >> 3));
    for (let row = 0; row < h; row++) {
      const line = raw.subarray(at + row * (size + 1) + 1, at + (row + 1) * (size + 1));
      for (let col = 0; col < w; col++) write(line, col, ((y + row * dy) * format.width + x + col * dx) * 4);
    }
    at += rawSizes[i];
  }
  return out;
}

/** Adam7 passes: origin and step of each (PNG, 8.1). */
const ADAM7 = [
  { x: 0, y: 0, dx: 8, dy: 8 },
  { x: 4, y: 0, dx: 8, dy: 8 },
  { x: 0, y: 4, dx: 4, dy: 8 },
  { x: 2, y: 0, dx: 4, dy: 4 },
  { x: 0, y: 2, dx: 2, dy: 4 },
  { x: 1, y: 0, dx: 2, dy: 2 },
  { x: 0, y: 1, dx: 1, dy: 2 },
];

/** Channels and depths of each colour type. */
const COLOR_TYPES: Readonly<Record<number, { readonly channels: number; readonly depths: readonly number[] }>> = {
  0: { channels: 1, depths: [1, 2, 4, 8, 16] },
  2: { channels: 3, depths: [8, 16] },
  3: { channels: 1, depths: [1, 2, 4, 8] },
  4: { channels: 2, depths: [8, 16] },
  6: { channels: 4, depths: [8, 16] },
};

interface Chunks {
  readonly byType: ReadonlyMap<string, Uint8Array>;
  readonly data: readonly Uint8Array[];
}

interface Format {
  readonly width: number;
  readonly height: number;
  readonly depth: number;
  readonly channels: number;
  readonly isInterlaced: boolean;
  /** RGB, 3 bytes a colour. */
  readonly palette: Uint8Array | undefined;
  readonly transparency: Uint8Array | undefined;
}

function readChunks(bytes: Uint8Array): Chunks {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const byType = new Map<string, Uint8Array>();
  const data: Uint8Array[] = [];
  for (let at = 8; !byType.has('IEND'); ) {
    const length = view.getUint32(at);
    const end = at + 8 + length;
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    const crc = view.getUint32(end);
    // Checksums of ancillary chunks are not verified.
    const isNeeded = ['IHDR', 'PLTE', 'tRNS', 'IDAT'].includes(type);
    if (isNeeded && crc32(bytes.subarray(at + 4, end)) !== crc) throw new MessageError(msg`wrong check sum of ${type}`);
    if (type === 'IDAT') data.push(bytes.subarray(at + 8, end));
    else byType.set(type, bytes.subarray(at + 8, end));
    at = end + 4;
  }
  return { byType, data };
}

function readFormat({ byType }: Chunks): Format {
  const header = byType.get('IHDR');
  if (header?.length !== 13) throw new MessageError(msg`no header`);
  const view = new DataView(header.buffer, header.byteOffset, 13);
  const [depth, colorType, compression, filter, interlace] = header.subarray(8);
  const color = COLOR_TYPES[colorType];
  if (!color?.depths.includes(depth)) throw new MessageError(msg`colour type ${colorType} with ${depth} bits`);
  if (compression !== 0 || filter !== 0 || interlace > 1)
    throw new MessageError(msg`unknown compression, filter or interlacing`);
  const palette = colorType === 3 ? byType.get('PLTE') : undefined;
  if (colorType === 3 && !palette) throw new MessageError(msg`no palette`);
  return {
    width: view.getUint32(0),
    height: view.getUint32(4),
    depth,
    channels: color.channels,
    isInterlaced: interlace === 1,
    palette,
    transparency: byType.get('tRNS'),
  };
}

/** Undoes the prediction of each row in place (PNG, 9.2). `step`: bytes to the pixel on the left. */
function unfilter(raw: Uint8Array, rowBytes: number, step: number): void {
  for (let start = 0; start < raw.length; start += rowBytes + 1) {
    const filter = raw[start];
    if (filter > 4) throw new MessageError(msg`row filter ${filter}`);
    if (filter === 0) continue;
    for (let i = 1; i <= rowBytes; i++) {
      const at = start + i;
      const left = i > step ? raw[at - step] : 0;
      const up = start > 0 ? raw[at - rowBytes - 1] : 0;
      if (filter === 1) raw[at] += left;
      else if (filter === 2) raw[at] += up;
      else if (filter === 3) raw[at] += (left + up) >> 1;
      else raw[at] += paeth(left, up, start > 0 && i > step ? raw[at - rowBytes - 1 - step] : 0);
    }
  }
}

/** Paeth predictor: of left, up and up-left the one nearest to left + up − up-left. */
function paeth(left: number, up: number, corner: number): number {
  const [toLeft, toUp, toCorner] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)];
  if (toLeft <= toUp && toLeft <= toCorner) return left;
  return toUp <= toCorner ? up : corner;
}

type PixelWriter = (line: Uint8Array, column: number, to: number) => void;

function pixelWriter(format: Format, out: Uint8Array): PixelWriter {
  const { channels, depth, palette, transparency } = format;
  if (palette) return paletteWriter(format, palette, out);
  const scale = 255 / (2 ** depth - 1);
  const key = transparency && channels % 2 === 1 ? keyOf(transparency, channels) : undefined;
  const gray = channels < 3;
  return (line, column, to) => {
    const from = column * channels;
    const first = sample(line, from, depth);
    const second = gray ? first : sample(line, from + 1, depth);
    const third = gray ? first : sample(line, from + 2, depth);
    out[to] = Math.round(first * scale);
    out[to + 1] = Math.round(second * scale);
    out[to + 2] = Math.round(third * scale);
    if (channels % 2 === 0) out[to + 3] = Math.round(sample(line, from + channels - 1, depth) * scale);
    else out[to + 3] = key && key[0] === first && (gray || (key[1] === second && key[2] === third)) ? 0 : 255;
  };
}

function paletteWriter({ depth, transparency }: Format, palette: Uint8Array, out: Uint8Array): PixelWriter {
  return (line, column, to) => {
    const color = sample(line, column, depth);
    if (color * 3 + 2 >= palette.length) throw new MessageError(msg`palette has no colour ${color}`);
    for (let k = 0; k < 3; k++) out[to + k] = palette[color * 3 + k];
    out[to + 3] = transparency?.[color] ?? 255;
  };
}

/** The transparent colour key, at the image's own depth. */
function keyOf(transparency: Uint8Array, channels: number): number[] {
  return Array.from({ length: channels }, (_, k) => (transparency[2 * k] << 8) | transparency[2 * k + 1]);
}

/** Sample `i` of a row; several share a byte where they have less than 8 bits, the first in the highest. */
function sample(line: Uint8Array, i: number, depth: number): number {
  if (depth === 8) return line[i];
  if (depth === 16) return (line[2 * i] << 8) | line[2 * i + 1];
  const bit = i * depth;
  return (line[bit >> 3] >> (8 - depth - (bit & 7))) & (2 ** depth - 1);
}
