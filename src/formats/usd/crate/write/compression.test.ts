import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { CrateSource, Cursor } from '../structure/crateSource.ts';
import { readInt32s, readInt64s } from '../structure/integerCompression.ts';
import { decompress, MAX_EXPANSION } from '../structure/lz4.ts';
import { ByteSink } from './byteSink.ts';
import { packInt32s, packInt64s, writeSized } from './integers.ts';
import { compress } from './lz4.ts';

function unpacked(data: Uint8Array, room: number): Uint8Array {
  const out = new Uint8Array(room);
  return out.subarray(0, decompress(new CrateSource(data, 'a', 2 ** 30), 0, data.length, out));
}

function cursorOf(packed: Uint8Array): Cursor {
  const sink = new ByteSink();
  writeSized(sink, packed);
  return new Cursor(new CrateSource(sink.bytes, 'a', 2 ** 30), 0);
}

/** Bytes with many repeats near and far, short and long. */
const repetitive = fc
  .array(
    fc.tuple(
      fc.uint8Array({ minLength: 1, maxLength: 12 }),
      fc.oneof(fc.integer({ min: 1, max: 4 }), fc.integer({ min: 1, max: 3000 })),
    ),
    { maxLength: 12 },
  )
  .map((parts) =>
    Uint8Array.from(parts.flatMap(([bytes, times]) => Array.from({ length: times }, () => [...bytes]).flat())),
  );

describe('LZ4', () => {
  it('round-trips', () => {
    fc.assert(
      fc.property(fc.oneof(fc.uint8Array({ maxLength: 400 }), repetitive), (data) => {
        expect(Buffer.from(unpacked(compress(data), data.length)).equals(data)).toBe(true);
      }),
    );
  });

  it('round-trips what is at the limits of its lengths and distances', () => {
    const noise = Uint8Array.from({ length: 70000 }, (_, i) => (Math.imul(i + 1, 2654435761) >>> 13) & 255);
    for (const gap of [65534, 65535, 65536])
      for (const length of [3, 4, 18, 19, 20, 273, 274, 529]) {
        const data = new Uint8Array(gap + length + 12);
        data.set(noise.subarray(0, gap));
        data.set(noise.subarray(0, length), gap);
        expect(Buffer.from(unpacked(compress(data), data.length)).equals(data), `${gap} ${length}`).toBe(true);
      }
  });

  it('packs one repeated byte as far as the format goes', () => {
    const data = new Uint8Array(10 ** 6);
    expect(compress(data).length).toBeLessThan((1.01 * data.length) / MAX_EXPANSION + 20);
  });
});

/** Integers near each other, or any. */
const integers = (bits: number) => {
  const any = fc.bigInt({ min: -(2n ** BigInt(bits - 1)), max: 2n ** BigInt(bits - 1) - 1n });
  const near = [100n, 30000n, 2n ** 31n - 1n].map((most) => fc.bigInt({ min: -most, max: most }));
  return fc.oneof(...[any, ...near].map((one) => fc.array(one, { minLength: 1, maxLength: 80 })));
};

describe('integers', () => {
  it('of 32 bits round-trip, with and without sign', () => {
    fc.assert(
      fc.property(integers(32), (values) => {
        for (const list of [
          Int32Array.from(values, Number),
          Uint32Array.from(values, (x) => Number(BigInt.asUintN(32, x))),
        ])
          expect(readInt32s(cursorOf(packInt32s(list)), list.length, 'x')).toEqual(new Int32Array(list.buffer));
      }),
    );
  });

  it('of 64 bits round-trip, with and without sign', () => {
    fc.assert(
      fc.property(integers(64), (values) => {
        const signed = BigInt64Array.from(values);
        for (const list of [signed, new BigUint64Array(signed.buffer)])
          expect(readInt64s(cursorOf(packInt64s(list)), list.length, 'x')).toEqual(new Uint32Array(signed.buffer));
      }),
    );
  });

  it('that rise evenly take next to nothing', () => {
    expect(packInt32s(Int32Array.from({ length: 10 ** 5 }, (_, i) => 3 * i + 3)).length).toBeLessThan(130);
  });
});
