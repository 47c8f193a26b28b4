import { toHalf } from '../../../../math/half.ts';
import type { NumberArray, Value } from '../../layer/layer.ts';
import { ByteSink } from './byteSink.ts';
import type { PackContext } from './packContext.ts';
import { inlined, stored } from './rep.ts';
import type { CodedType } from './typeCodes.ts';

/** One value of a type that can stand in arrays: in its representation where that holds it, else in the file. */
export function packScalar(
  context: PackContext,
  type: CodedType,
  data: Extract<Value, { data: unknown }>['data'],
): bigint {
  switch (type.kind) {
    case 'bool':
      return inlined(type.code, data ? 1 : 0);
    case 'number':
      return packNumber(context, type, data as number);
    case 'long':
      return packLong(context, type, data as bigint);
    case 'text':
      return packText(context, type, data as string);
    case 'tuple':
      return packTuple(context, type, data as NumberArray);
  }
}

const scratch = new DataView(new ArrayBuffer(4));

export function floatBits(value: number): number {
  scratch.setFloat32(0, value);
  return scratch.getUint32(0);
}

/** Doubles are inlined as floats, where a float holds them; time codes never are. */
function packNumber(context: PackContext, { code, storage, scalar }: CodedType<'number'>, value: number): bigint {
  if (scalar === 'half') return inlined(code, toHalf(value));
  if (scalar === 'float') return inlined(code, floatBits(value));
  if (scalar !== 'double') return inlined(code, value);
  if (storage === 'double' && Number.isFinite(value) && Math.fround(value) === value)
    return inlined(code, floatBits(value));
  const sink = new ByteSink();
  sink.f64(value);
  return stored(code, context.place(sink.bytes));
}

/** 64-bit integers are inlined with 32 bits, where these hold them. */
function packLong(context: PackContext, { code, storage }: CodedType<'long'>, value: bigint): bigint {
  const short = storage === 'int64' ? BigInt.asIntN(32, value) : BigInt.asUintN(32, value);
  if (short === value) return inlined(code, Number(short));
  const sink = new ByteSink();
  sink.big(value);
  return stored(code, context.place(sink.bytes));
}

/** Assets are inlined as tokens, though arrays have them as strings. */
function packText(context: PackContext, { code, storage }: CodedType<'text'>, text: string): bigint {
  const { tokens } = context;
  if (storage === 'token' || storage === 'asset') return inlined(code, tokens.index(text));
  if (storage === 'string') return inlined(code, tokens.stringIndex(text));
  const sink = new ByteSink();
  sink.u32(tokens.stringIndex(text));
  return stored(code, context.place(sink.bytes));
}

/** Small whole numbers are inlined as bytes with a sign: all of a vector, or the diagonal of a matrix. */
function packTuple(
  context: PackContext,
  { code, storage, scalar, size }: CodedType<'tuple'>,
  data: NumberArray,
): bigint {
  if (storage === 'half2') return inlined(code, toHalf(data[0]) | (toHalf(data[1]) << 16));
  const small = storage.startsWith('quat')
    ? undefined
    : smallBits(data, storage.startsWith('matrix') ? Math.sqrt(size) + 1 : 1);
  if (small !== undefined) return inlined(code, small);
  return stored(code, context.place(numberBytes(data, scalar)));
}

/** Every `step`-th number as a byte, where the others are zero; undefined where that is not all of them. −0 is not 0. */
function smallBits(data: NumberArray, step: number): number | undefined {
  let bits = 0;
  for (const [i, x] of data.entries()) {
    if (Object.is(x, -0) || x !== (x << 24) >> 24 || (i % step !== 0 && x !== 0)) return undefined;
    if (i % step === 0) bits |= (x & 255) << ((8 * i) / step);
  }
  return bits;
}

/** The bytes of numbers as a crate has them: halves take two. */
export function numberBytes(data: NumberArray, scalar: string): Uint8Array {
  const numbers = scalar === 'half' ? Uint16Array.from(data, toHalf) : data;
  return new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
}
