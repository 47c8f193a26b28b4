import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { random } from '../../math/random.ts';
import { contentBytes, contentHead, FileWindow, RangedFile } from './rangedFile.ts';

const next = random(20261121);
const whole = Uint8Array.from({ length: 300_000 }, () => 256 * next());
const ranged = new RangedFile({ name: 'a', handle: whole }, whole.length);

describe('a ranged file', () => {
  it('has slices, and slices of slices', () => {
    expect([...ranged.part(1000, 500).part(7, 20).read(2, 3)]).toEqual([...whole.subarray(1009, 1012)]);
    expect(contentBytes(ranged.part(10, 40))).toEqual(whole.slice(10, 50));
    expect(contentHead(ranged.part(0, 3), 8)).toEqual(whole.slice(0, 3));
  });

  it('is the same through a sliding window', () => {
    const [window, memory] = [new FileWindow(ranged), new FileWindow(whole)];
    const range = fc.tuple(fc.nat(whole.length - 1), fc.nat(140_000));
    fc.assert(
      fc.property(fc.array(range, { minLength: 1, maxLength: 8 }), fc.boolean(), (ranges, copy) => {
        for (const [at, most] of ranges) {
          const length = Math.min(most, whole.length - at);
          const seen = [window, memory].map((w) => {
            if (copy) return w.slice(at, length);
            w.ensure(at, length);
            return w.bytes.subarray(at - w.base, at - w.base + length);
          });
          expect(Buffer.compare(seen[0], whole.subarray(at, at + length))).toBe(0);
          expect(Buffer.compare(seen[1], seen[0])).toBe(0);
        }
      }),
    );
  });
});
