import { toHalf } from '../../../math/half.ts';
import { msg } from '../../../messages/message.ts';
import { MessageError, messageOf } from '../../../messages/messageError.ts';
import { InputError } from '../../../scene/types.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import { checkRadianceSize, type DecodedRadiance, storeRadiance } from './radianceLimits.ts';

/** One byte of a run of the old kind stands for so many pixels at most; of the new kind for fewer. */
const MAX_PIXELS_PER_BYTE = 64;
/** Lengths of lines that may be packed by their components. */
const PACKED = [8, 0x7fff] as const;
/** A byte of a packed line above this begins a run. */
const MAX_LITERAL = 128;

/**
 * Reads a Radiance picture (`.hdr`, `.pic`): RGBE, flat or run-length encoded, rows from the top or from the bottom. Values are radiance over
 * the EXPOSURE that the header tells. Source: Ward, "Real pixels" (Graphics Gems II); radsite.lbl.gov/radiance/refer/filefmts.pdf.
 * Throws an InputError that names `name` where it cannot.
 */
export function readHdr(bytes: Uint8Array, name: string): DecodedRadiance {
  try {
    const header = readHeader(bytes, name);
    const { width, height } = header;
    checkRadianceSize(width, height, name);
    if (width * height > MAX_PIXELS_PER_BYTE * (bytes.length - header.end))
      throw new MessageError(msg`too short for its size`);
    return { width, height, data: readRows(bytes, header) };
  } catch (thrown) {
    if (thrown instanceof InputError) throw thrown;
    const message = msg`the Radiance picture is damaged or cut off (${messageOf(thrown)}); export it again`;
    throw inputError('image.damaged', name, message, thrown);
  }
}

interface HdrHeader {
  readonly width: number;
  readonly height: number;
  readonly upsideDown: boolean;
  /** What values are multiplied with. */
  readonly gain: number;
  /** Where the pixels begin. */
  readonly end: number;
}

/** Lines of text that a header may have, and their length. */
const MAX_HEADER_LINES = 1000;
const MAX_HEADER_LINE = 4096;

function readHeader(bytes: Uint8Array, name: string): HdrHeader {
  let end = 0;
  const line = (): string => {
    const stop = bytes.indexOf(10, end);
    if (stop < 0 || stop - end > MAX_HEADER_LINE) throw new MessageError(msg`a header without an end`);
    const text = new TextDecoder().decode(bytes.subarray(end, stop)).trim();
    end = stop + 1;
    return text;
  };
  let gain = 1;
  let lines = 0;
  for (let text = line(); text !== ''; text = line()) {
    if (++lines > MAX_HEADER_LINES) throw new MessageError(msg`a header without an end`);
    const [, key, value] = /^(\w+)\s*=\s*(.*)$/.exec(text) ?? [];
    if (key === 'FORMAT' && value !== '32-bit_rle_rgbe') {
      const message = msg`a Radiance picture of ${value.slice(0, 40)} is not read; save it as RGBE`;
      throw inputError('image.unsupported', name, message);
    }
    if (key === 'EXPOSURE') gain /= Number.parseFloat(value);
  }
  const size = line();
  const [, sign, height, width] = /^([-+])Y\s+(\d{1,9})\s+\+X\s+(\d{1,9})$/.exec(size) ?? [];
  if (!sign)
    throw inputError(
      'image.unsupported',
      name,
      msg`a Radiance picture with rows as '${size.slice(0, 40)}' is not read; save it with -Y +X`,
    );
  if (!(gain > 0 && Number.isFinite(gain))) throw new MessageError(msg`an exposure that is not above 0`);
  return { width: Number(width), height: Number(height), upsideDown: sign === '+', gain, end };
}

function readRows(bytes: Uint8Array, { width, height, upsideDown, gain, end }: HdrHeader): Uint16Array {
  const data = new Uint16Array(4 * width * height);
  const row = new Uint8Array(4 * width);
  const ONE = toHalf(1);
  let at = end;
  for (let y = 0; y < height; y++) {
    at = isPacked(bytes, at, width) ? readPacked(bytes, at + 4, row) : readPlain(bytes, at, row);
    const to = 4 * width * (upsideDown ? height - 1 - y : y);
    for (let i = 0; i < row.length; i += 4) {
      // A mantissa of 8 bits, its middle taken; exponents count from 128.
      const unit = row[i + 3] === 0 ? 0 : gain * 2 ** (row[i + 3] - 136);
      storeRadiance(data, to + i, (row[i] + 0.5) * unit, (row[i + 1] + 0.5) * unit, (row[i + 2] + 0.5) * unit);
      data[to + i + 3] = ONE;
    }
  }
  return data;
}

const isPacked = (bytes: Uint8Array, at: number, width: number): boolean =>
  width >= PACKED[0] &&
  width <= PACKED[1] &&
  bytes[at] === 2 &&
  bytes[at + 1] === 2 &&
  (bytes[at + 2] << 8) + bytes[at + 3] === width;

/** The four components one after the other, each in runs and literals; where the next row begins. */
function readPacked(bytes: Uint8Array, start: number, row: Uint8Array): number {
  let at = start;
  const width = row.length / 4;
  for (let k = 0; k < 4; k++)
    for (let x = 0; x < width; ) {
      const head = byteAt(bytes, at++);
      const isRun = head > MAX_LITERAL;
      const count = isRun ? head - MAX_LITERAL : head;
      if (count === 0 || x + count > width) throw new MessageError(msg`a run of ${count} pixels at ${x} of ${width}`);
      for (let i = 0; i < count; i++) row[4 * (x + i) + k] = byteAt(bytes, isRun ? at : at + i);
      at += isRun ? 1 : count;
      x += count;
    }
  return at;
}

/** Pixel by pixel; (1, 1, 1, n) repeats the last one n times, after another such one 256 n times. */
function readPlain(bytes: Uint8Array, start: number, row: Uint8Array): number {
  let at = start;
  let shift = 0;
  for (let i = 0; i < row.length; ) {
    const pixel = [0, 1, 2, 3].map((k) => byteAt(bytes, at + k));
    at += 4;
    if (pixel[0] !== 1 || pixel[1] !== 1 || pixel[2] !== 1) {
      row.set(pixel, i);
      i += 4;
      shift = 0;
      continue;
    }
    const to = i + 4 * pixel[3] * 2 ** shift;
    if (i === 0 || to > row.length) throw new MessageError(msg`a run that does not fit`);
    for (; i < to; i += 4) row.copyWithin(i, i - 4, i);
    shift += 8;
    if (shift > 24) throw new MessageError(msg`a run that does not fit`);
  }
  return at;
}

function byteAt(bytes: Uint8Array, at: number): number {
  if (at >= bytes.length) throw new MessageError(msg`its pixels end too early`);
  return bytes[at];
}
