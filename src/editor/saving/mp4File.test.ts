import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type EncodedFrame, Mp4File } from './mp4File.ts';

const viewOf = (bytes: Uint8Array): DataView => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

/** The boxes of an MP4 file or box, with their content. */
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
const TRACK = ['moov', 'trak', 'mdia'];
const STBL = [...TRACK, 'minf', 'stbl'];

async function fileOf(fps: number, frames: readonly EncodedFrame[]): Promise<Uint8Array> {
  const film = await Mp4File.begin({ codec: 'vp9', fps, count: frames.length });
  const decoderConfig = { codec: 'vp09.00.10.08', codedWidth: 64, codedHeight: 48 };
  for (const frame of frames) await film.add(frame, { decoderConfig });
  return new Uint8Array(await film.finish());
}

/** Decoding time of each frame [s], from the file's durations. */
function times(file: Uint8Array): number[] {
  const scale = viewOf(inside(file, ...TRACK, 'mdhd')!).getUint32(12);
  const runs = numbers(inside(file, ...STBL, 'stts')!, 8);
  const found: number[] = [];
  for (let i = 0, now = 0; i < runs.length; i += 2)
    for (let n = 0; n < runs[i]!; n++, now += runs[i + 1]!) found.push(now / scale);
  return found;
}

describe('an MP4 file', () => {
  it('indexes every frame, its duration and the key frames, before the media data', async () => {
    const data = fc.uint8Array({ minLength: 1, maxLength: 40 });
    const frames = fc
      .array(fc.record({ data, key: fc.boolean() }), { minLength: 1, maxLength: 20 })
      .map((list) => list.map(({ data: of, key }, index) => ({ data: of, key: key || index === 0, index })));
    await fc.assert(
      fc.asyncProperty(frames, async (all) => {
        const file = await fileOf(24, all);
        const order = boxes(file).map(([type]) => type);
        expect(order.indexOf('moov')).toBeLessThan(order.indexOf('mdat'));
        const sizes = numbers(inside(file, ...STBL, 'stsz')!, 12);
        expect(sizes).toEqual(all.map((frame) => frame.data.length));
        // That few frames are a single chunk.
        let at = viewOf(inside(file, ...STBL, 'stco')!).getUint32(8);
        for (const frame of all) {
          expect([...file.subarray(at, at + frame.data.length)]).toEqual([...frame.data]);
          at += frame.data.length;
        }
        const keys = all.flatMap(({ key }, i) => (key ? [i + 1] : []));
        const told = inside(file, ...STBL, 'stss');
        if (told) expect(numbers(told, 8)).toEqual(keys);
        else expect(keys).toHaveLength(all.length);
      }),
      { numRuns: 30 },
    );
  });

  it.each([24, 23.976, 30_000 / 1001, 0.1, 120])(
    'presents each frame at its time, at %d frames per second',
    async (fps) => {
      const all = Array.from({ length: 200 }, (_, index) => ({
        data: Uint8Array.of(index),
        key: index % 48 === 0,
        index,
      }));
      const found = times(await fileOf(fps, all));
      expect(found).toHaveLength(200);
      for (const [i, time] of found.entries()) expect(time * fps).toBeCloseTo(i, 4);
    },
  );

  it('has presentation times for frames decoded in another order', async () => {
    const all = [0, 2, 1].map((index) => ({ data: Uint8Array.of(index), key: index === 0, index }));
    const file = await fileOf(24, all);
    const scale = viewOf(inside(file, ...TRACK, 'mdhd')!).getUint32(12);
    const runs = numbers(inside(file, ...STBL, 'ctts')!, 8);
    const offsets = runs.flatMap((count, i) => (i % 2 === 0 ? Array<number>(count).fill(runs[i + 1]!) : []));
    const seen = times(file).map((time, i) => 24 * (time + offsets[i]! / scale));
    expect(seen.map((index) => index - seen[0]!)).toEqual([0, 2, 1]);
  });
});
