import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type EncodedFrame, type Film, mp4 } from './mp4.ts';

const whole = (film: Film): Uint8Array => Uint8Array.from(mp4(film).flatMap((part) => [...part]));
const viewOf = (bytes: Uint8Array): DataView => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

/** The boxes of a file, or in another, with what is in them. */
function boxes(bytes: Uint8Array): [type: string, content: Uint8Array][] {
  const found: [string, Uint8Array][] = [];
  for (let at = 0; at < bytes.length; ) {
    const view = viewOf(bytes.subarray(at));
    const short = view.getUint32(0);
    const [size, header] = short === 1 ? [Number(view.getBigUint64(8)), 16] : [short, 8];
    expect(size).toBeGreaterThanOrEqual(header);
    found.push([String.fromCharCode(...bytes.subarray(at + 4, at + 8)), bytes.subarray(at + header, at + size)]);
    at += size;
    expect(at).toBeLessThanOrEqual(bytes.length);
  }
  return found;
}
const inside = (bytes: Uint8Array, ...path: readonly string[]): Uint8Array | undefined =>
  path.reduce<Uint8Array | undefined>((box, name) => box && boxes(box).find(([type]) => type === name)?.[1], bytes);

const numbers = (bytes: Uint8Array, from: number): number[] =>
  Array.from({ length: (bytes.length - from) / 4 }, (_, i) => viewOf(bytes).getInt32(from + 4 * i));

const data = fc.uint8Array({ minLength: 1, maxLength: 40 });
const frames = fc
  .array(fc.record({ data, key: fc.boolean() }), { minLength: 1, maxLength: 20 })
  .map((list) => list.map((frame, place): EncodedFrame => ({ ...frame, place })));
const STBL = ['moov', 'trak', 'mdia', 'minf', 'stbl'];

describe('an MP4 file', () => {
  it('leads to every picture, its length and its key frames', () => {
    fc.assert(
      fc.property(frames, fc.boolean(), (all, old) => {
        const codec = old
          ? ({ kind: 'vp9', level: 51 } as const)
          : ({ kind: 'h264', description: Uint8Array.of(1, 2) } as const);
        const file = whole({ width: 64, height: 48, fps: 24, codec, frames: all });
        expect(boxes(file).map(([type]) => type)).toEqual(['ftyp', 'moov', 'mdat']);
        let at = Number(viewOf(inside(file, ...STBL, 'co64')!).getBigUint64(8));
        const sizes = numbers(inside(file, ...STBL, 'stsz')!, 12);
        const read = sizes.map((size) => {
          at += size;
          return [...file.subarray(at - size, at)];
        });
        expect(read).toEqual(all.map((frame) => [...frame.data]));
        expect(at).toBe(file.length);
        const keys = all.flatMap(({ key }, i) => (key ? [i + 1] : []));
        expect(numbers(inside(file, ...STBL, 'stss')!, 8)).toEqual(keys);
        expect(inside(file, ...STBL, 'ctts')).toBeUndefined();
      }),
    );
  });

  it('lasts as long as its frames, also of fractions of a second', () => {
    const frame = { data: Uint8Array.of(1), key: true };
    const all = Array.from({ length: 30 }, (_, place) => ({ ...frame, place }));
    const file = whole({ width: 64, height: 48, fps: 23.976, codec: { kind: 'vp9', level: 10 }, frames: all });
    const header = viewOf(inside(file, 'moov', 'mvhd')!);
    expect(Number(header.getBigUint64(24)) / header.getUint32(20)).toBeCloseTo(30 / 23.976, 9);
    expect(numbers(inside(file, ...STBL, 'stts')!, 4)).toEqual([1, 30, 1000]);
  });

  it('tells when pictures are seen that are decoded in another order', () => {
    const places = [0, 2, 1];
    const all = places.map((place) => ({ data: Uint8Array.of(place), key: place === 0, place }));
    const file = whole({ width: 64, height: 48, fps: 24, codec: { kind: 'vp9', level: 10 }, frames: all });
    expect(numbers(inside(file, ...STBL, 'ctts')!, 8)).toEqual([1, 0, 1, 1000, 1, -1000]);
  });
});
