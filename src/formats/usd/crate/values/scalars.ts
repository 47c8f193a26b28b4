import { fromHalf } from '../../../../math/half.ts';
import { msg } from '../../../../messages/message.ts';
import type { NumberArray, Value } from '../../layer/layer.ts';
import { type CrateSource, Cursor } from '../structure/crateSource.ts';
import { readNumber, type TextTable, TYPED_ARRAYS } from './arrays.ts';
import type { ArrayType, CrateScalar } from './crateTypes.ts';
import type { ValueRep } from './valueRep.ts';

/** One value of a type that can stand in arrays, in its representation or in the file. */
export function readScalar(source: CrateSource, rep: ValueRep, type: ArrayType, texts: TextTable): Value {
  switch (type.kind) {
    case 'bool':
      return { type: 'bool', data: numberOf(source, rep, 'bool') !== 0 };
    case 'number':
      return { type: type.storage, data: numberOf(source, rep, type.scalar) };
    case 'long':
      return { type: type.storage, data: readLong(source, rep, type.storage) };
    case 'text':
      return { type: type.storage, data: readText(source, rep, type.storage, texts) };
    case 'tuple':
      return { type: type.storage, data: readTuple(source, rep, type) };
  }
}

const scratch = new DataView(new ArrayBuffer(4));

/** Doubles are inlined as floats, where a float holds them. */
function numberOf(source: CrateSource, rep: ValueRep, scalar: CrateScalar): number {
  if (!rep.isInlined) return readNumber(new Cursor(source, rep.offset), scalar);
  const { low } = rep;
  switch (scalar) {
    case 'bool':
    case 'uchar':
      return low & 0xff;
    case 'int':
      return low | 0;
    case 'uint':
      return low;
    case 'half':
      return fromHalf(low & 0xffff);
    default:
      scratch.setUint32(0, low);
      return scratch.getFloat32(0);
  }
}

/** 64-bit integers are inlined with 32 bits, where these hold them. */
function readLong(source: CrateSource, rep: ValueRep, storage: 'int64' | 'uint64'): bigint {
  const { low } = rep;
  if (rep.isInlined) return BigInt(storage === 'int64' ? low | 0 : low);
  const value = new Cursor(source, rep.offset).big(msg`an integer of 64 bits`);
  return storage === 'int64' ? value : BigInt.asUintN(64, value);
}

/** Assets are inlined as tokens, though arrays have them as strings. */
function readText(source: CrateSource, rep: ValueRep, storage: string, texts: TextTable): string {
  const index = rep.isInlined ? rep.low : new Cursor(source, rep.offset).u32(msg`a value of type ${storage}`);
  return storage === 'token' || storage === 'asset' ? texts.token(index, rep.at) : texts.string(index, rep.at);
}

type CrateTupleType = Extract<ArrayType, { kind: 'tuple' }>;

/** Small whole numbers are inlined as bytes with a sign: all of a vector, or the diagonal of a matrix. */
function readTuple(source: CrateSource, rep: ValueRep, { scalar, size, storage }: CrateTupleType): NumberArray {
  source.spend(TUPLE_BYTES, msg`a value of type ${storage}`, rep.at);
  const out = new TYPED_ARRAYS[scalar](size);
  if (!rep.isInlined) {
    const cursor = new Cursor(source, rep.offset);
    for (let i = 0; i < size; i++) out[i] = readNumber(cursor, scalar);
    return out;
  }
  if (storage === 'half2') return Float32Array.of(fromHalf(rep.low & 0xffff), fromHalf(rep.low >>> 16));
  const byte = (i: number): number => (rep.low << (24 - 8 * i)) >> 24;
  const step = storage.startsWith('matrix') ? Math.sqrt(size) + 1 : 1;
  for (let i = 0; i * step < size; i++) out[i * step] = byte(i);
  return out;
}

/** What a small array costs. */
const TUPLE_BYTES = 160;
