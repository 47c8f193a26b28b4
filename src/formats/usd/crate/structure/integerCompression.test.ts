import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { bytes, sized, stored, u32, u64 } from '../fixtures/writeCrate.ts';
import { CrateSource, Cursor } from './crateSource.ts';
import { readInt32s, readInt64s } from './integerCompression.ts';

/** Bits of the three sizes of a difference. */
const LENGTHS = { 32: [8, 16, 32], 64: [16, 32, 64] } as const;

/** An independent encoder: with big integers, and any choice of the common difference. */
function encode(values: readonly bigint[], width: 32 | 64, common: bigint): Uint8Array {
  const lengths = LENGTHS[width];
  const wrap = (x: bigint): bigint => BigInt.asIntN(width, x);
  const differences = values.map((value, i) => wrap(value - (values[i - 1] ?? 0n)));
  const codes = differences.map((d) =>
    d === common ? 0 : 1 + lengths.findIndex((bits) => BigInt.asIntN(bits, d) === d),
  );
  const packed = new Uint8Array(Math.ceil(values.length / 4));
  codes.forEach((code, i) => {
    packed[i >> 2] |= code << (2 * (i & 3));
  });
  const written = differences.map((d, i) => u64(d).subarray(0, codes[i] === 0 ? 0 : lengths[codes[i] - 1] / 8));
  return sized(stored(bytes(u64(common).subarray(0, width / 8), packed, ...written)));
}

const cursorOf = (data: Uint8Array): Cursor => new Cursor(new CrateSource(data, 'a', 2 ** 20), 0);

/** Integers near each other, or arbitrary. */
const list = (width: 32 | 64) => {
  const whole = fc.bigInt({ min: -(2n ** BigInt(width - 1)), max: 2n ** BigInt(width - 1) - 1n });
  return fc.array(fc.oneof(whole, fc.bigInt({ min: -200n, max: 200n })), { minLength: 1, maxLength: 60 });
};

describe('integers round-trip', () => {
  it('of 32 bits', () => {
    fc.assert(
      fc.property(list(32), fc.bigInt({ min: -200n, max: 200n }), (values, common) => {
        const read = readInt32s(cursorOf(encode(values, 32, common)), values.length, 'x');
        expect(Array.from(read, BigInt)).toEqual(values);
      }),
    );
  });

  it('of 64 bits', () => {
    fc.assert(
      fc.property(list(64), fc.bigInt({ min: -200n, max: 200n }), (values, common) => {
        const read = readInt64s(cursorOf(encode(values, 64, common)), values.length, 'x');
        expect([...new BigInt64Array(read.buffer)]).toEqual(values);
      }),
    );
  });

  it('or are rejected if bytes are missing', () => {
    const data = encode([1n, 2n, 300n, 70000n], 32, 5n);
    expect(() => readInt32s(cursorOf(data), 5, 'x')).toThrow('of 5 x the compressed data holds');
    expect(() => readInt32s(cursorOf(data), 40, 'x')).toThrow('of 40 x the compressed data holds');
    expect(() => readInt64s(cursorOf(sized(stored(u32(1, 0, 255)))), 2, 'x')).toThrow(
      'of 2 x the compressed data holds 0',
    );
  });
});
