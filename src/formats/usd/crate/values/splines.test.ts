import { describe, expect, it } from 'vitest';
import type { Spline } from '../../layer/layer.ts';
import { bytes, rep, u32, u64 } from '../fixtures/writeCrate.ts';
import { CrateSource, Cursor } from '../structure/crateSource.ts';
import type { ValueDecoder } from './fieldValue.ts';
import { readSpline } from './splines.ts';
import { ValueRep } from './valueRep.ts';

const f64 = (...numbers: readonly number[]): Uint8Array => new Uint8Array(Float64Array.from(numbers).buffer);

function read(spline: Uint8Array): Spline {
  const source = new CrateSource(bytes(u64(spline.length), spline, u64(0)), 'a', 2 ** 20);
  const halves = new Uint32Array(BigUint64Array.of(rep(59, 0)).buffer);
  return readSpline({ source } as ValueDecoder, new ValueRep(source, halves[0], halves[1]), new Cursor(source, 0));
}

/** Version 1 or more, of doubles. */
const header = (version: number, modes: number): number[] => [version | 0x10, modes];
const knot = (flags: number, time: number): Uint8Array => bytes([flags], f64(time, 7, 0.5, 0.25, 1, 2));

describe('a spline in a crate', () => {
  it('loops after its end, where usd-core 25.11 reads only two of the three bits', () => {
    const kinds = [4, 5, 6].map((mode) => read(bytes(header(1, 1 | (mode << 3)), u32(0))).after.kind);
    expect(kinds).toEqual(['repeat', 'reset', 'oscillate']);
  });

  it('has tangent algorithms since version 2', () => {
    const algorithms = (version: number, ...rest: number[]) => {
      const { pre, post } = read(bytes(header(version, 9), u32(1), knot(6, 1), rest)).knots[0];
      return [pre.algorithm, post.algorithm];
    };
    expect(algorithms(1)).toEqual(['none', 'none']);
    expect(algorithms(2, 0x12)).toEqual(['autoEase', 'custom']);
  });

  it.each<[string, Uint8Array, string]>([
    ['of version 4', bytes(header(4, 9), u32(0)), 'a spline is of version 4; 1 to 3 are read'],
    ['of version 3 with another type', bytes(header(3, 9), [1], u32(0)), 'a spline has values of an unknown type'],
    ['with tangents of Maya', bytes(header(1, 9), u32(1), knot(0x16, 1)), "tangents in Maya's form"],
    [
      'with knots out of order',
      bytes(header(1, 9), u32(2), knot(0, 1), knot(0, 1)),
      'knot 1 of a spline is at the time 1',
    ],
    [
      'with a knot at no time',
      bytes(header(1, 9), u32(1), knot(0, Number.NaN)),
      'knot 0 of a spline is at the time NaN',
    ],
    ['that goes on in no known way', bytes(header(1, 7), u32(0)), 'a spline extrapolates in way 7'],
    [
      'with more bytes than it says',
      bytes(header(1, 9), u32(0), [0]),
      'a spline has 7 bytes, and what it says takes 6',
    ],
    ['with fewer knots than it says', bytes(header(1, 9), u32(9)), 'the file ends at byte'],
    ['made in no known way', bytes(header(2, 9), u32(1), knot(0, 1), [0x33]), 'tangents are made in way 3'],
  ])('%s is refused', (_, spline, message) => {
    expect(() => read(spline)).toThrow(message);
  });
});
