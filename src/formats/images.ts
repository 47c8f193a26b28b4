import { type DecodedPng, decode as decodePngFile } from 'fast-png';
import { decode as decodeJpegFile } from 'jpeg-js';
import { InputError } from '../scene/types.ts';
import { inputError, messageOf } from './fail.ts';

/** A picture as textures use it: RGBA, 8 bits each, rows from the top, alpha not premultiplied. */
export interface DecodedImage {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8Array;
}

/** Largest side and area [pixels] that are decoded: 64 megapixels are 256 MiB of RGBA. */
const MAX_SIDE = 16384;
const MAX_PIXELS = 2 ** 26;

/** Decodes a PNG or JPEG by its content (not its name). Throws an InputError that names `name` where it cannot. */
export function decodeImage(bytes: Uint8Array, name: string): DecodedImage {
  const kind = kindOf(bytes);
  if (kind !== 'PNG' && kind !== 'JPEG') throw refused(name, kind);
  try {
    return kind === 'PNG' ? decodePng(bytes, name) : decodeJpeg(bytes, name);
  } catch (thrown) {
    if (thrown instanceof InputError) throw thrown;
    const message = `the ${kind} is damaged or cut off (${messageOf(thrown)}); export it again`;
    throw inputError('image.damaged', name, message, thrown);
  }
}

function kindOf(bytes: Uint8Array): string {
  const starts = (magic: string, at = 0): boolean => [...magic].every((c, i) => bytes[at + i] === c.charCodeAt(0));
  if (bytes.length === 0) return 'empty';
  if (starts('\x89PNG\r\n\x1a\n')) return 'PNG';
  if (starts('\xff\xd8\xff')) return 'JPEG';
  if (starts('RIFF') && starts('WEBP', 8)) return 'WebP';
  if (starts('ftypavif', 4)) return 'AVIF';
  if (starts('\xabKTX')) return 'KTX2';
  if (starts('\x76\x2f\x31\x01')) return 'OpenEXR';
  if (starts('#?RADIANCE')) return 'Radiance HDR';
  return 'unknown';
}

function refused(name: string, kind: string): InputError {
  if (kind === 'empty') return inputError('image.empty', name, 'the picture is empty (0 bytes); copy it again');
  const what = kind === 'unknown' ? 'neither PNG nor JPEG' : `${kind}, which is not read`;
  return inputError('image.unknown-format', name, `the picture is ${what}; convert it to PNG or JPEG`);
}

function checkSize(width: number, height: number, name: string): void {
  if (width > 0 && height > 0 && width <= MAX_SIDE && height <= MAX_SIDE && width * height <= MAX_PIXELS) return;
  const limit = `1 to ${MAX_SIDE} a side and at most ${MAX_PIXELS / 2 ** 20} Mi pixels are read`;
  throw inputError('image.size', name, `the picture is ${width} × ${height} pixels, ${limit}; scale it`);
}

function decodeJpeg(bytes: Uint8Array, name: string): DecodedImage {
  const end = bytes.lastIndexOf(0xd9);
  if (end < 1 || bytes[end - 1] !== 0xff) throw new Error('no end marker');
  const { width, height } = jpegSize(bytes);
  checkSize(width, height, name);
  const image = decodeJpegFile(bytes, { useTArray: true, maxResolutionInMP: 100, maxMemoryUsageInMB: 2048 });
  return { width: image.width, height: image.height, data: image.data };
}

/** Size from the frame header (SOF marker, ITU T.81 B.2.2), before anything is allocated for it. */
function jpegSize(bytes: Uint8Array): { width: number; height: number } {
  const u16 = (at: number): number => (bytes[at] << 8) | bytes[at + 1];
  let at = 2;
  while (at + 9 < bytes.length) {
    if (bytes[at] !== 0xff || bytes[at + 1] === 0xff) {
      at++;
      continue;
    }
    const marker = bytes[at + 1];
    const isFrame = marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc;
    if (isFrame) return { height: u16(at + 5), width: u16(at + 7) };
    at += 2 + Math.max(2, u16(at + 2));
  }
  throw new Error('no frame header');
}

function decodePng(bytes: Uint8Array, name: string): DecodedImage {
  if (bytes.length < 45) throw new Error(`${bytes.length} bytes only`);
  const header = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  checkSize(header.getUint32(16), header.getUint32(20), name);
  // fast-png reads interlaced rows as whole bytes per pixel, which is wrong for packed ones.
  if (header.getUint8(28) === 1 && header.getUint8(24) < 8) {
    const message = 'interlaced PNG with less than 8 bits a channel is not read; save it without interlacing';
    throw inputError('image.unknown-format', name, message);
  }
  const png = decodePngFile(bytes, { checkCrc: true });
  return { width: png.width, height: png.height, data: toRgba8(png) };
}

/** Any PNG pixel layout → RGBA8. 16-bit values are rounded, packed greys scaled to 0 … 255. */
function toRgba8(png: DecodedPng): Uint8Array {
  const { width, height, channels } = png;
  const max = 2 ** png.depth - 1;
  const samples = unpack(png);
  const out = new Uint8Array(width * height * 4);
  const isKey = transparentKey(png);
  const to8 = (value: number): number => (png.depth === 8 ? value : Math.round((value * 255) / max));
  for (let i = 0, from = 0, to = 0; i < width * height; i++, from += channels, to += 4) {
    if (png.palette) {
      const color = png.palette[samples[from]];
      if (!color) throw new Error(`palette has no colour ${samples[from]}`);
      out.set([color[0], color[1], color[2], color[3] ?? 255], to);
      continue;
    }
    const grey = channels < 3;
    out[to] = to8(samples[from]);
    out[to + 1] = to8(samples[grey ? from : from + 1]);
    out[to + 2] = to8(samples[grey ? from : from + 2]);
    out[to + 3] = channels % 2 === 0 ? to8(samples[from + channels - 1]) : isKey(samples, from) ? 0 : 255;
  }
  return out;
}

/** One number per channel and pixel, also where the PNG packs several pixels in a byte. */
function unpack(png: DecodedPng): ArrayLike<number> {
  if (png.depth >= 8) return png.data;
  const { width, height, depth, data } = png;
  const rowBytes = Math.ceil((width * depth) / 8);
  const mask = 2 ** depth - 1;
  const out = new Uint8Array(width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const bit = x * depth;
      out[y * width + x] = (data[y * rowBytes + (bit >> 3)] >> (8 - depth - (bit & 7))) & mask;
    }
  }
  return out;
}

/** Whether the pixel at `from` has the one colour that the tRNS chunk of a grey or RGB picture makes transparent. */
function transparentKey(png: DecodedPng): (samples: ArrayLike<number>, from: number) => boolean {
  const key = png.palette ? undefined : png.transparency;
  if (!key || key.length < png.channels) return () => false;
  return (samples, from) => {
    for (let c = 0; c < png.channels; c++) if (samples[from + c] !== key[c]) return false;
    return true;
  };
}
