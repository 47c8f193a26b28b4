import { toHalf } from '../../../../math/half.ts';
import type { NumberArray, Value } from '../../layer/layer.ts';
import { AS_INTEGERS, BY_TABLE, MIN_COMPRESSED_LENGTH } from '../values/arrays.ts';
import type { CrateScalar } from '../values/crateTypes.ts';
import { ByteSink } from './byteSink.ts';
import { packInt64s, writeInt32s, writeSized } from './integers.ts';
import type { PackContext } from './packContext.ts';
import { storedArray } from './rep.ts';
import { numberBytes } from './scalars.ts';
import type { CodedType } from './typeCodes.ts';
import { ARRAY_ALIGNMENT } from './valueStore.ts';

type ArrayData = Extract<Value, { readonly type: `${string}[]` }>['data'];

/** How many items, then the items, as they are or compressed where that is shorter. */
export function packArray(context: PackContext, type: CodedType, data: ArrayData): bigint {
  const count = type.kind === 'tuple' ? data.length / type.size : data.length;
  if (count === 0) return storedArray(type.code, 0, false);
  const plain = plainBytes(context, type, data);
  const short = count < MIN_COMPRESSED_LENGTH ? undefined : compressed(type, data);
  const isCompressed = short !== undefined && short.length < plain.length;
  const sink = new ByteSink();
  sink.u64(count);
  sink.append(isCompressed ? short : plain);
  const alignment = isCompressed || type.kind === 'text' ? 1 : ARRAY_ALIGNMENT;
  return storedArray(type.code, context.place(sink.bytes, alignment), isCompressed);
}

function plainBytes({ tokens }: PackContext, type: CodedType, data: ArrayData): Uint8Array {
  if (type.kind === 'text') {
    const indexOf = (text: string): number =>
      type.storage === 'token' ? tokens.index(text) : tokens.stringIndex(text);
    return numberBytes(Uint32Array.from(data as readonly string[], indexOf), 'uint');
  }
  if (type.kind === 'long') {
    const { buffer, byteOffset, byteLength } = data as BigInt64Array;
    return new Uint8Array(buffer, byteOffset, byteLength);
  }
  return numberBytes(data as NumberArray, type.kind === 'bool' ? 'bool' : type.scalar);
}

/** Integers, and numbers that are integers or few different ones; undefined for others. */
function compressed(type: CodedType, data: ArrayData): Uint8Array | undefined {
  const sink = new ByteSink();
  if (type.kind === 'long') writeSized(sink, packInt64s(data as BigInt64Array));
  else if (type.kind === 'number' && type.storage !== 'timecode' && type.storage !== 'uchar')
    return compressedNumbers(type.scalar, data as NumberArray);
  else return undefined;
  return sink.bytes;
}

function compressedNumbers(scalar: CrateScalar, data: NumberArray): Uint8Array | undefined {
  if (scalar !== 'int' && scalar !== 'uint') return shorter(asIntegers(data), byTable(scalar, data));
  const sink = new ByteSink();
  writeInt32s(sink, data);
  return sink.bytes;
}

const shorter = (a: Uint8Array | undefined, b: Uint8Array | undefined): Uint8Array | undefined =>
  a && b ? (a.length <= b.length ? a : b) : (a ?? b);

const isInt32 = (x: number): boolean => x === (x | 0) && !Object.is(x, -0);

function asIntegers(data: NumberArray): Uint8Array | undefined {
  if (!data.every(isInt32)) return undefined;
  const sink = new ByteSink();
  sink.u8(AS_INTEGERS);
  writeInt32s(sink, data);
  return sink.bytes;
}

/** A table holds at most so many numbers, and a quarter as many as the array (OpenUSD, crateFile.cpp). */
const MAX_TABLE_LENGTH = 1024;

function byTable(scalar: CrateScalar, data: NumberArray): Uint8Array | undefined {
  const all = bitsOf(scalar, data);
  const limit = Math.min(MAX_TABLE_LENGTH, Math.floor(all.length / 4));
  const places = new Map<number | bigint, number>();
  const indices = new Int32Array(all.length);
  for (let i = 0; i < all.length; i++) {
    let place = places.get(all[i]);
    if (place === undefined) {
      if (places.size === limit) return undefined;
      place = places.size;
      places.set(all[i], place);
    }
    indices[i] = place;
  }
  const sink = new ByteSink();
  sink.u8(BY_TABLE);
  sink.u32(places.size);
  sink.append(tableBytes(all, places.keys()));
  writeInt32s(sink, indices);
  return sink.bytes;
}

type Bits = Uint16Array | Uint32Array | BigUint64Array;

/** Numbers by their bits, so that −0 is not 0 and no kind of NaN is another. */
function bitsOf(scalar: CrateScalar, data: NumberArray): Bits {
  const { buffer, byteOffset, length } = data;
  if (scalar === 'half') return Uint16Array.from(data, toHalf);
  return scalar === 'float'
    ? new Uint32Array(buffer, byteOffset, length)
    : new BigUint64Array(buffer, byteOffset, length);
}

function tableBytes(all: Bits, table: Iterable<number | bigint>): Uint8Array {
  const numbers =
    all instanceof BigUint64Array
      ? BigUint64Array.from(table as Iterable<bigint>)
      : all instanceof Uint32Array
        ? Uint32Array.from(table as Iterable<number>)
        : Uint16Array.from(table as Iterable<number>);
  return new Uint8Array(numbers.buffer);
}
