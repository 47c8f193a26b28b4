import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { SampleRing } from './sampleRing.ts';

describe('the ring of samples', () => {
  it('requests each sample of a window once, and the next ones in the direction of play', () => {
    const ring = new SampleRing(10, 100);
    expect(ring.request(20, 4)).toEqual({ missing: [20, 21, 22, 23], prefetch: [24, 25, 26, 27, 28, 29] });
    for (let k = 20; k < 26; k++) ring.markResident(k);
    expect(ring.request(22, 4)).toEqual({ missing: [], prefetch: [26, 27, 28, 29, 30, 31] });
    expect(ring.request(19, 4)).toEqual({ missing: [19], prefetch: [18, 17, 16, 15, 14, 13] });
  });

  it('prefetches only samples of the motion', () => {
    const ring = new SampleRing(10, 24);
    expect(ring.request(20, 4).prefetch).toEqual([]);
    expect(ring.request(1, 2).prefetch).toEqual([0]);
  });

  it('after any sequence of windows the last one is resident, and prefetched samples replaced none of it', () => {
    const windows = fc.array(fc.tuple(fc.nat(90), fc.integer({ min: 2, max: 10 })), { minLength: 1, maxLength: 40 });
    fc.assert(
      fc.property(fc.integer({ min: 10, max: 30 }), windows, (capacity, plays) => {
        const ring = new SampleRing(capacity, 100);
        const places = new Map<number, number>();
        for (const [first, count] of plays) {
          const { missing, prefetch: next } = ring.request(first, count);
          for (const k of [...missing, ...next]) {
            places.set(k % capacity, k);
            ring.markResident(k);
          }
          for (let k = first; k < first + count; k++) expect(places.get(k % capacity)).toBe(k);
        }
      }),
    );
  });
});
