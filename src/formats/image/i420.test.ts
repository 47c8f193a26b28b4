import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { i420 } from './i420.ts';

/** Y′, C_B, C_R of 2 × 2 pixels of one colour. */
function plain(r: number, g: number, b: number): readonly number[] {
  const out = i420(2, 2, Uint8Array.from([r, g, b, 255, r, g, b, 255, r, g, b, 255, r, g, b, 255]));
  expect(out).toHaveLength(6);
  expect(new Set(out.subarray(0, 4)).size).toBe(1);
  return [out[0]!, out[4]!, out[5]!];
}

describe('I420 frames', () => {
  // 100 % colour bars in 8 bits of BT.709, as in every table of them.
  it.each([
    ['black', [0, 0, 0], [16, 128, 128]],
    ['white', [255, 255, 255], [235, 128, 128]],
    ['red', [255, 0, 0], [63, 102, 240]],
    ['green', [0, 255, 0], [173, 42, 26]],
    ['blue', [0, 0, 255], [32, 240, 118]],
    ['yellow', [255, 255, 0], [219, 16, 138]],
    ['cyan', [0, 255, 255], [188, 154, 16]],
  ] as const)('%s agrees with BT.709', (_, [r, g, b], expected) => {
    expect(plain(r, g, b)).toEqual(expected);
  });

  it('round-trip up to rounding', () => {
    const level = fc.integer({ min: 0, max: 255 });
    fc.assert(
      fc.property(level, level, level, (r, g, b) => {
        const [luma, blue, red] = plain(r, g, b) as [number, number, number];
        const light = ((luma - 16) * 255) / 219;
        const back = [light + (1.5748 * 255 * (red - 128)) / 224, light + (1.8556 * 255 * (blue - 128)) / 224];
        expect(Math.abs(back[0]! - r)).toBeLessThan(2);
        expect(Math.abs(back[1]! - b)).toBeLessThan(2);
      }),
    );
  });

  it('have the mean chroma of four pixels, and the luma of each', () => {
    const rgba = new Uint8Array(4 * 4 * 2).fill(255);
    rgba.set([0, 0, 0], 0);
    const out = i420(4, 2, rgba);
    expect([...out.subarray(0, 8)]).toEqual([16, 235, 235, 235, 235, 235, 235, 235]);
    expect([...out.subarray(8)]).toEqual([128, 128, 128, 128]);
  });
});
