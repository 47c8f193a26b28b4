import { type LocalizedText, msg } from '../../../../messages/message.ts';
import type { CrateSource, Cursor } from './crateSource.ts';
import { decompress, MAX_EXPANSION } from './lz4.ts';

/**
 * `count` integers of 32 bits: their differences in 0, 8, 16 or 32 bits, two bits each saying which, compressed
 * (OpenUSD, Sdf_IntegerCompression). No bits stand for the commonest difference, which comes first.
 */
export function readInt32s(cursor: Cursor, count: number, what: LocalizedText): Int32Array {
  const { source, at } = cursor;
  const { view, codes, from, size } = unpack(cursor, count, 4, what);
  const common = view.getInt32(0, true);
  const out = new Int32Array(count);
  let read = from;
  let value = 0;
  for (let i = 0; i < count; i++) {
    const code = (view.getUint8(codes + (i >> 2)) >> ((i & 3) * 2)) & 3;
    const length = code === 3 ? 4 : code;
    if (read + length > size) failTruncated(source, what, i, count, at);
    if (code === 0) value += common;
    else if (code === 1) value += view.getInt8(read);
    else if (code === 2) value += view.getInt16(read, true);
    else value += view.getInt32(read, true);
    value |= 0;
    read += length;
    out[i] = value;
  }
  return out;
}

/** The same of 64 bits: differences in 0, 16, 32 or 64 bits. Returns pairs of 32 bits, the low ones first. */
export function readInt64s(cursor: Cursor, count: number, what: LocalizedText): Uint32Array<ArrayBuffer> {
  const { source, at } = cursor;
  const { view, codes, from, size } = unpack(cursor, count, 8, what);
  const common = [view.getUint32(0, true), view.getInt32(4, true)];
  const out = new Uint32Array(2 * count);
  let read = from;
  let [low, high] = [0, 0];
  for (let i = 0; i < count; i++) {
    const code = (view.getUint8(codes + (i >> 2)) >> ((i & 3) * 2)) & 3;
    const length = code === 0 ? 0 : 2 ** code;
    if (read + length > size) failTruncated(source, what, i, count, at);
    let [addLow, addHigh] = common;
    if (code === 3) [addLow, addHigh] = [view.getUint32(read, true), view.getInt32(read + 4, true)];
    else if (code !== 0) {
      const small = code === 1 ? view.getInt16(read, true) : view.getInt32(read, true);
      [addLow, addHigh] = [small >>> 0, small >> 31];
    }
    const sum = low + addLow;
    low = sum >>> 0;
    high = (high + addHigh + (sum > 0xffffffff ? 1 : 0)) | 0;
    read += length;
    out[2 * i] = low;
    out[2 * i + 1] = high;
  }
  return out;
}

interface PackedIntegers {
  readonly view: DataView;
  /** Where the two-bit codes begin, and the differences. */
  readonly codes: number;
  readonly from: number;
  readonly size: number;
}

function unpack(cursor: Cursor, count: number, width: 4 | 8, what: LocalizedText): PackedIntegers {
  const { source, at } = cursor;
  const length = cursor.count(msg`bytes of compressed ${what}`, 1);
  const from = cursor.pass(length, what);
  // Of no numbers OpenUSD stores not even the commonest difference.
  if (count === 0) return { view: new DataView(new ArrayBuffer(width)), codes: 0, from: 0, size: 0 };
  const codeBytes = Math.ceil(count / 4);
  const least = width + codeBytes;
  if (least > MAX_EXPANSION * length)
    source.fail(msg`it says ${count} ${what}, which ${length} compressed bytes cannot hold`, at);
  source.spend(width * count, msg`an array of ${count} numbers`, at);
  const scratch = scratchOf(Math.min(least + width * count, MAX_EXPANSION * length));
  const size = decompress(source, from, length, scratch);
  if (size < least) failTruncated(source, what, 0, count, at);
  return { view: new DataView(scratch.buffer), codes: width, from: least, size };
}

function failTruncated(source: CrateSource, what: LocalizedText, i: number, count: number, at: number): never {
  return source.fail(msg`of ${count} ${what} the compressed data holds ${i}`, at);
}

/** Size of the scratch buffer kept between calls [bytes]. */
const SCRATCH_BYTES = 2 ** 20;
let scratchBuffer = new Uint8Array(0);

function scratchOf(size: number): Uint8Array {
  if (size > SCRATCH_BYTES) return new Uint8Array(size);
  if (scratchBuffer.length === 0) scratchBuffer = new Uint8Array(SCRATCH_BYTES);
  return scratchBuffer;
}
