import fc from 'fast-check';
import { expect, it } from 'vitest';
import { decodeTransfer, encodeTransfer } from './transferCodec.ts';

const sent = <T extends object>(value: T): T => decodeTransfer(encodeTransfer(value).buffer) as T;

const numbers = fc.oneof(
  fc.float32Array(),
  fc.float64Array(),
  fc.uint8Array(),
  fc.uint16Array(),
  fc.uint32Array(),
  fc.uint8ClampedArray(),
);
const part = fc.oneof(fc.double(), fc.string(), fc.boolean(), fc.constant(null), fc.constant(undefined), numbers);
/** Arrays of numbers, which also encode table indices, are values like all others. */
const nested = fc.letrec<{ tree: unknown }>((tie) => ({
  tree: fc.oneof(
    { maxDepth: 4 },
    part,
    fc.array(tie('tree'), { maxLength: 4 }),
    fc.dictionary(fc.stringMatching(/^[a-z]{1,5}$/), tie('tree'), { maxKeys: 4 }),
  ),
})).tree;

it('round-trips values to the last bit', () => {
  fc.assert(
    fc.property(fc.array(nested), (value) => {
      expect(sent(value)).toStrictEqual(structuredClone(value));
    }),
  );
});

it('shared objects are sent once, and stay shared', () => {
  const mesh = { positions: new Float32Array(3000), colors: undefined };
  const scene = { objects: Array.from({ length: 1000 }, (_, i) => ({ path: `/${i}`, mesh })) };
  const bytes = encodeTransfer(scene);
  expect(bytes.length).toBeLessThan(120_000);
  const { objects } = decodeTransfer(bytes.buffer) as typeof scene;
  expect(new Set(objects.map((object) => object.mesh)).size).toBe(1);
  expect(objects[999]!.path).toBe('/999');
});

it('a view of a buffer is sent as its part, a Node Buffer as its bytes, and cycles are preserved', () => {
  const ring: { data: Uint8Array; bytes: Uint8Array; self?: object } = {
    data: new Uint8Array([1, 2, 3, 4, 5]).subarray(1, 4),
    bytes: Buffer.from('words'),
  };
  ring.self = ring;
  const back = sent(ring);
  expect(back.data).toEqual(new Uint8Array([2, 3, 4]));
  expect(new TextDecoder().decode(back.bytes)).toBe('words');
  expect(back.self).toBe(back);
});

it.each([() => 1, new Map(), 1n, new Date(0), new DataView(new ArrayBuffer(1))])(
  'unsupported values are rejected, not dropped: %s',
  (odd) => {
    expect(() => encodeTransfer({ odd })).toThrow(/cannot be sent/);
  },
);
