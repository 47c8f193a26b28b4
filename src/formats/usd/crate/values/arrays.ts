import { fromHalf } from '../../../../math/half.ts';
import { msg } from '../../../../messages/message.ts';
import { storedByteLength } from '../../../../scene/streaming/storedNumbers.ts';
import type { NumberArray, Value } from '../../layer/layer.ts';
import { StoredArray } from '../../layer/storedArray.ts';
import { type CrateSource, Cursor } from '../structure/crateSource.ts';
import { readInt32s, readInt64s } from '../structure/integerCompression.ts';
import type { ArrayType, CrateScalar } from './crateTypes.ts';
import type { ValueRep } from './valueRep.ts';

const A_NUMBER = msg`a number`;
const INTEGERS = msg`integers`;

/** Shorter arrays are never compressed, even if flagged so. */
export const MIN_COMPRESSED_LENGTH = 16;

const SCALAR_BYTES = { bool: 1, uchar: 1, int: 4, uint: 4, half: 2, float: 4, double: 8 } as const;

export const TYPED_ARRAYS = {
  bool: Uint8Array,
  uchar: Uint8Array,
  int: Int32Array,
  uint: Uint32Array,
  half: Float32Array,
  float: Float32Array,
  double: Float64Array,
} as const;

type CrateTupleArrayType = Extract<ArrayType, { kind: 'tuple' }>;

/** What a text in an array costs: a reference. */
const REFERENCE_BYTES = 8;

/** Looks up tokens and strings by index. */
export interface TextTable {
  token(index: number, at?: number): string;
  string(index: number, at?: number): string;
}

/** An array that lies in the file: how many items, then the items, as they are or compressed. */
export function readArray(source: CrateSource, rep: ValueRep, type: ArrayType, texts: TextTable): Value {
  const cursor = new Cursor(source, rep.offset);
  const isEmpty = rep.isInlined || rep.offset === 0;
  const count = isEmpty ? 0 : readLength(cursor);
  const compressed = rep.isCompressed && count >= MIN_COMPRESSED_LENGTH;
  switch (type.kind) {
    case 'text':
      return { type: `${type.storage}[]`, data: readTexts(cursor, count, type.storage, texts) };
    case 'bool':
      return { type: 'bool[]', data: readNumbers(cursor, 'bool', count).map((x) => (x === 0 ? 0 : 1)) };
    case 'long': {
      const pairs = compressed ? readInt64s(cursor, count, INTEGERS) : readPairs(cursor, count);
      return type.storage === 'int64'
        ? { type: 'int64[]', data: new BigInt64Array(pairs.buffer) }
        : { type: 'uint64[]', data: new BigUint64Array(pairs.buffer) };
    }
    case 'number':
      return {
        type: `${type.storage}[]`,
        data: compressed ? readCompressed(cursor, type.scalar, count) : readNumbers(cursor, type.scalar, count),
      };
    case 'tuple':
      return (
        storedInFile(cursor, type, count) ?? {
          type: `${type.storage}[]`,
          data: readNumbers(cursor, type.scalar, count * type.size),
        }
      );
  }
}

/** Minimum size of arrays of tuples that are left on disk [bytes]. */
const MIN_STORED_BYTES = 2 ** 12;

/** A large array left on disk; undefined if small or in memory. */
function storedInFile(
  cursor: Cursor,
  { storage, scalar, size }: CrateTupleArrayType,
  count: number,
): StoredArray | undefined {
  if (scalar !== 'half' && scalar !== 'float' && scalar !== 'double') return undefined;
  const { source } = cursor;
  const bytes = storedByteLength({ count: count * size, scalar });
  const part = bytes >= MIN_STORED_BYTES ? source.part(0, source.size) : undefined;
  if (!part) return undefined;
  const at = part.start + cursor.skip(bytes, msg`an array of ${count} tuples`);
  return new StoredArray(`${storage}[]`, { file: part.file, at, count: count * size, scalar });
}

/** Before 0.5 the rank preceded the length; before 0.7 the length had 32 bits. */
function readLength(cursor: Cursor): number {
  const { source } = cursor;
  if (source.version < 5) cursor.u32(msg`the rank of an array`);
  const { at } = cursor;
  const length = source.version < 7 ? cursor.u32(msg`the length of an array`) : cursor.i64(msg`the length of an array`);
  return length >= 0 && length < 2 ** 31 ? length : source.fail(msg`an array has length ${length}`, at);
}

function readTexts(cursor: Cursor, count: number, storage: string, texts: TextTable): string[] {
  const { source } = cursor;
  const from = cursor.pass(4 * count, msg`an array of ${count} texts`);
  source.spend(REFERENCE_BYTES * count, msg`an array of ${count} texts`, from);
  return Array.from({ length: count }, (_, i) => {
    const at = from + 4 * i;
    const index = source.view.getUint32(at - source.base, true);
    return storage === 'token' ? texts.token(index, at) : texts.string(index, at);
  });
}

/** One number as it lies. */
export function readNumber(cursor: Cursor, scalar: CrateScalar): number {
  const at = cursor.pass(SCALAR_BYTES[scalar], A_NUMBER) - cursor.source.base;
  const { view } = cursor.source;
  switch (scalar) {
    case 'half':
      return fromHalf(view.getUint16(at, true));
    case 'float':
      return view.getFloat32(at, true);
    case 'double':
      return view.getFloat64(at, true);
    case 'int':
      return view.getInt32(at, true);
    case 'uint':
      return view.getUint32(at, true);
    default:
      return view.getUint8(at);
  }
}

/** Below this size numbers are read one by one, without a buffer [bytes]. */
const MIN_COPIED_BYTES = 64;

/** `count` numbers as they lie. Halves become f32. */
export function readNumbers(cursor: Cursor, scalar: CrateScalar, count: number): NumberArray {
  const { source } = cursor;
  const size = SCALAR_BYTES[scalar] * count;
  const from = cursor.skip(size, msg`an array of ${count} numbers`);
  source.spend(scalar === 'half' ? 2 * size : size, msg`an array of ${count} numbers`, from);
  const NumbersArray = TYPED_ARRAYS[scalar];
  if (size < MIN_COPIED_BYTES) {
    const out = new NumbersArray(count);
    const each = new Cursor(source, from);
    for (let i = 0; i < count; i++) out[i] = readNumber(each, scalar);
    return out;
  }
  // A copy: aligned, and it does not retain the file.
  const { buffer } = source.slice(from, size);
  return scalar === 'half' ? Float32Array.from(new Uint16Array(buffer), fromHalf) : new NumbersArray(buffer);
}

function readPairs(cursor: Cursor, count: number): Uint32Array<ArrayBuffer> {
  const from = cursor.skip(8 * count, msg`an array of ${count} numbers`);
  cursor.source.spend(8 * count, msg`an array of ${count} numbers`, from);
  return new Uint32Array(cursor.source.slice(from, 8 * count).buffer);
}

/** How numbers are compressed: as integers, or as places in a table. */
export const [AS_INTEGERS, BY_TABLE] = ['i', 't'].map((c) => c.charCodeAt(0));

function readCompressed(cursor: Cursor, scalar: CrateScalar, count: number): NumberArray {
  const { source, at } = cursor;
  if (scalar === 'int') return readInt32s(cursor, count, INTEGERS);
  if (scalar === 'uint') return new Uint32Array(readInt32s(cursor, count, INTEGERS).buffer);
  if (scalar === 'uchar' || scalar === 'bool') return source.fail(msg`an array of ${scalar} says it is compressed`, at);
  const code = cursor.u8(msg`how numbers are compressed`);
  if (code !== AS_INTEGERS && code !== BY_TABLE)
    source.fail(msg`numbers are compressed in an unknown way (${code})`, at);
  const FloatArray = TYPED_ARRAYS[scalar];
  source.spend(FloatArray.BYTES_PER_ELEMENT * count, msg`an array of ${count} numbers`, at);
  if (code === AS_INTEGERS) return FloatArray.from(readInt32s(cursor, count, msg`whole numbers`));
  const table = readNumbers(cursor, scalar, cursor.u32(msg`the size of a table of numbers`));
  return lookUp(source, table, readInt32s(cursor, count, msg`places in a table`), new FloatArray(count), at);
}

function lookUp<T extends NumberArray>(
  source: CrateSource,
  table: NumberArray,
  places: Int32Array,
  out: T,
  at: number,
): T {
  for (let i = 0; i < places.length; i++) {
    const place = places[i];
    if (place < 0 || place >= table.length)
      source.fail(msg`number ${i} of an array is at place ${place} of a table of ${table.length}`, at);
    out[i] = table[place];
  }
  return out;
}
