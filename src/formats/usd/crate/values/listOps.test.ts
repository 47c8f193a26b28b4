import { describe, expect, it } from 'vitest';
import type { MetadataValue } from '../../layer/layer.ts';
import { bytes, DATA_START, rep, u32, u64, writeCrate } from '../fixtures/writeCrate.ts';
import { readCrate } from '../readCrate.ts';
import { NON_ARRAY_TYPES } from './crateTypes.ts';

const TOKENS = ['', 'primChildren', 'A', 'note', 'a.usd', 'x'];
const token = (text: string): number => TOKENS.indexOf(text);

/** The value of a prim’s metadata `note` that is stored as `data`. */
function noteOf(type: number, data: Uint8Array, { flags = '', version = 8 } = {}): MetadataValue | undefined {
  const children = bytes(u64(1), u32(token('A')));
  const crate = writeCrate({
    version,
    tokens: TOKENS,
    strings: [token(''), token('a.usd'), token('x')],
    data: bytes(data, children),
    fields: [
      [token('primChildren'), rep(NON_ARRAY_TYPES.tokenVector, DATA_START + data.length)],
      [token('note'), rep(type, flags === 'i' ? 0 : DATA_START, flags)],
    ],
    fieldSets: [0, -1, 1, -1],
    paths: [
      [0, 0, -1],
      [1, token('A'), -2],
    ],
    specs: [
      [0, 0, 7],
      [1, 2, 6],
    ],
  });
  return readCrate(crate, 'a.usdc').rootPrims.get('A')!.metadata.get('note');
}

const f64 = (...numbers: readonly number[]): Uint8Array => new Uint8Array(Float64Array.from(numbers).buffer);

describe('list ops', () => {
  it('have a list for each bit, in the order of the format', () => {
    const list = (x: number): Uint8Array => bytes(u64(1), u32(x));
    // Added, prepended, appended, deleted, ordered.
    const data = bytes([4 | 32 | 64 | 8 | 16], list(10), list(20), list(30), list(40), list(50));
    expect(noteOf(NON_ARRAY_TYPES.intListOp, data)).toEqual({
      type: 'integers',
      op: { added: [10n], prepended: [20n], appended: [30n], deleted: [40n], ordered: [50n] },
    });
  });

  it('that are explicit may be empty, which is not absence', () => {
    expect(noteOf(NON_ARRAY_TYPES.tokenListOp, bytes([1]))).toEqual({ type: 'texts', op: { explicit: [] } });
    expect(noteOf(NON_ARRAY_TYPES.tokenListOp, bytes([0]))).toEqual({ type: 'texts', op: {} });
    expect(noteOf(NON_ARRAY_TYPES.tokenListOp, u64(0), { flags: 'i' })).toEqual({ type: 'texts', op: {} });
  });

  it.each<[string, number, Uint8Array, bigint]>([
    ['int', NON_ARRAY_TYPES.intListOp, u32(2 ** 32 - 1), -1n],
    ['uint', NON_ARRAY_TYPES.uintListOp, u32(2 ** 32 - 1), 2n ** 32n - 1n],
    ['int64', NON_ARRAY_TYPES.int64ListOp, u64(-1), -1n],
    ['uint64', NON_ARRAY_TYPES.uint64ListOp, u64(-1), 2n ** 64n - 1n],
  ])('of %s preserve sign and all digits', (_, type, item, expected) => {
    expect(noteOf(type, bytes([3], u64(1), item))).toEqual({ type: 'integers', op: { explicit: [expected] } });
  });

  it('are of tokens, strings or paths', () => {
    const data = bytes([3], u64(1), u32(1));
    expect(noteOf(NON_ARRAY_TYPES.tokenListOp, data)).toEqual({ type: 'texts', op: { explicit: ['primChildren'] } });
    expect(noteOf(NON_ARRAY_TYPES.stringListOp, data)).toEqual({ type: 'texts', op: { explicit: ['a.usd'] } });
    expect(noteOf(NON_ARRAY_TYPES.pathListOp, data)).toEqual({ type: 'paths', op: { explicit: ['/A'] } });
  });

  it('of payloads have time offsets since version 0.8', () => {
    const target = bytes([3], u64(1), u32(1, 1));
    const arc = { asset: 'a.usd', path: '/A' };
    const arcs = (offset: number, scale: number) => ({ type: 'arcs', op: { explicit: [{ ...arc, offset, scale }] } });
    expect(noteOf(NON_ARRAY_TYPES.payloadListOp, bytes(target, f64(5, 2)))).toEqual(arcs(5, 2));
    expect(noteOf(NON_ARRAY_TYPES.payloadListOp, target, { version: 7 })).toEqual(arcs(0, 1));
  });
});

describe('older and rare types', () => {
  it('are a single payload, and an empty one', () => {
    const data = bytes(u32(1, 1), f64(0, 1));
    const arc = { asset: 'a.usd', path: '/A', offset: 0, scale: 1 };
    expect(noteOf(NON_ARRAY_TYPES.payload, data)).toEqual({ type: 'arcs', op: { explicit: [arc] } });
    expect(noteOf(NON_ARRAY_TYPES.payload, u32(1, 1), { version: 7 })).toEqual({
      type: 'arcs',
      op: { explicit: [arc] },
    });
  });

  it('are vectors, which are arrays in text', () => {
    expect(noteOf(NON_ARRAY_TYPES.doubleVector, bytes(u64(2), f64(0.5, -0)))).toEqual({
      type: 'double[]',
      data: Float64Array.of(0.5, -0),
    });
    expect(noteOf(NON_ARRAY_TYPES.stringVector, bytes(u64(1), u32(2)))).toEqual({ type: 'token[]', data: ['x'] });
    expect(noteOf(NON_ARRAY_TYPES.tokenVector, u64(0), { flags: 'i' })).toEqual({ type: 'token[]', data: [] });
  });

  it('are nested values, up to a maximum depth', () => {
    const nested = bytes(u64(8, rep(3, 7, 'i')));
    expect(noteOf(NON_ARRAY_TYPES.value, nested)).toEqual({ type: 'int', data: 7 });
    expect(() => noteOf(NON_ARRAY_TYPES.value, u64(8, rep(NON_ARRAY_TYPES.value, DATA_START)))).toThrow(
      'values are nested more than 64 deep',
    );
    expect(noteOf(NON_ARRAY_TYPES.unregistered, bytes(u64(8, rep(10, 2, 'i'))))).toEqual({
      type: 'unregistered',
      data: 'x',
    });
  });

  it('are rejected if no field can have them', () => {
    expect(() => noteOf(NON_ARRAY_TYPES.offsetVector, bytes(u64(0)))).toThrow('its metadata note is of kind offsets');
    expect(() => noteOf(NON_ARRAY_TYPES.permission, u32(9))).toThrow('its permission is 9');
  });
});
