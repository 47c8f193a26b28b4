import decodeJpegFile from 'jpeg-js/lib/decoder.js';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import { InputError } from '../../scene/types.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { decodePngPixels } from './decodePng.ts';
import { imageKind, jpegFrame } from './imageKind.ts';

/** A texture image: RGBA8, rows from the top, straight alpha. */
export interface DecodedImage {
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
  /** Four bytes a pixel, as encoded in the file. */
  readonly data: Uint8Array;
}

/** Largest side and area [pixels] that are decoded: 64 megapixels are 256 MiB of RGBA. */
export const MAX_SIDE = 16384;
export const MAX_PIXELS = 2 ** 26;

/**
 * Decodes a PNG or JPEG, detected by content. Throws an InputError that names `name`.
 * @example
 * const png = encodePng(2, 1, new Uint8Array([255, 0, 0, 255, 0, 0, 255, 128]));
 * decodeImage(png, 'two.png'); // { width: 2, height: 1, data: [255, 0, 0, 255, 0, 0, 255, 128] }
 */
export function decodeImage(bytes: Uint8Array, name: LocalizedText): DecodedImage {
  const kind = imageKind(bytes);
  if (kind !== 'PNG' && kind !== 'JPEG') throw unreadableImage(name, kind);
  try {
    return kind === 'PNG' ? decodePng(bytes, name) : decodeJpeg(bytes, name);
  } catch (thrown) {
    if (thrown instanceof InputError) throw thrown;
    const message = msg`the ${kind} is damaged or cut off (${messageOf(thrown)}); export it again`;
    throw inputError('image.damaged', name, message, thrown);
  }
}

function unreadableImage(name: LocalizedText, kind: string): InputError {
  if (kind === 'empty') return inputError('image.empty', name, msg`the picture is empty (0 bytes); copy it again`);
  const what = kind === 'unknown' ? msg`neither PNG nor JPEG` : msg`${kind}, which is not read`;
  return inputError('image.unknown-format', name, msg`the picture is ${what}; convert it to PNG or JPEG`);
}

/** Throws an InputError that names `name`. */
export function checkSize(width: number, height: number, name: LocalizedText): void {
  if (width > 0 && height > 0 && width <= MAX_SIDE && height <= MAX_SIDE && width * height <= MAX_PIXELS) return;
  const limit = msg`1 to ${MAX_SIDE} a side and at most ${MAX_PIXELS / 2 ** 20} Mi pixels are read`;
  throw inputError('image.size', name, msg`the picture is ${width} × ${height} pixels, ${limit}; scale it`);
}

function decodeJpeg(bytes: Uint8Array, name: LocalizedText): DecodedImage {
  const end = bytes.lastIndexOf(0xd9);
  if (end < 1 || bytes[end - 1] !== 0xff) throw new MessageError(msg`no end marker`);
  const { width, height } = jpegSize(bytes);
  checkSize(width, height, name);
  const limits = { maxResolutionInMP: 100, maxMemoryUsageInMB: 2048 };
  const image = decodeJpegFile(bytes, {
    useTArray: true,
    ...(isRgbJpeg(bytes) && { colorTransform: false }),
    ...limits,
  });
  return { width: image.width, height: image.height, data: image.data };
}

/** Size from the frame header (SOF marker, ITU T.81 B.2.2), before anything is allocated for it. */
function jpegSize(bytes: Uint8Array): { width: number; height: number } {
  const at = jpegFrame(bytes);
  if (at < 0) throw new MessageError(msg`no frame header`);
  return { height: (bytes[at + 5] << 8) | bytes[at + 6], width: (bytes[at + 7] << 8) | bytes[at + 8] };
}

/** Whether its three components are red, green and blue. Source: libjpeg's `default_decompress_parms`. */
function isRgbJpeg(bytes: Uint8Array): boolean {
  const frame = jpegFrame(bytes);
  if (bytes[frame + 9] !== 3) return false;
  const segment = (marker: number, name: string): number => jpegSegment(bytes, frame, marker, name);
  if (segment(0xe0, 'JFIF\0') >= 0) return false;
  const adobe = segment(0xee, 'Adobe');
  if (adobe >= 0) return bytes[adobe + 15] === 0;
  return [0, 1, 2].every((k) => bytes[frame + 10 + 3 * k] === 'RGB'.charCodeAt(k));
}

/** Offset of the first segment with a marker and a name before `end`; −1: none. */
function jpegSegment(bytes: Uint8Array, end: number, marker: number, name: string): number {
  for (let at = 2; at + 4 < end; at += 2 + Math.max(2, (bytes[at + 2] << 8) | bytes[at + 3])) {
    while (bytes[at] !== 0xff || bytes[at + 1] === 0xff) if (++at >= end) return -1;
    if (bytes[at + 1] === marker && [...name].every((c, k) => bytes[at + 4 + k] === c.charCodeAt(0))) return at;
  }
  return -1;
}

function decodePng(bytes: Uint8Array, name: LocalizedText): DecodedImage {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  checkSize(width, height, name);
  return { width, height, data: decodePngPixels(bytes) };
}
