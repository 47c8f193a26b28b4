import { describe, expect, it } from 'vitest';
import { random } from '../../math/random.ts';
import { decodeImage } from './decodeImage.ts';
import { encodePng } from './encodePng.ts';
import { encodeTexture } from './encodeTexture.ts';

/** Kind of a PNG: 2 RGB, 3 palette, 6 RGBA. */
const kindOf = (png: Uint8Array): number => png[25];

/** All colours in turn, then any of them. */
function picture(colors: number, alpha: number): Uint8Array {
  const next = random(colors);
  return Uint8Array.from(
    Array.from({ length: 32 * 32 }, (_, i) => {
      const color = i < colors ? i : Math.floor(next() * colors);
      return [color & 255, color >> 8, (7 * color) & 255, i === 5 ? alpha : 255];
    }).flat(),
  );
}

describe('a texture is written as', () => {
  it.each([
    ['a palette of 20 colours', 20, 255, 3],
    ['a palette of 256 colours', 256, 255, 3],
    ['RGB, of more colours', 257, 255, 2],
    ['RGBA, with any alpha', 2, 254, 6],
  ])('%s, with the same pixels', (_, colors, alpha, kind) => {
    const pixels = picture(colors, alpha);
    const png = encodeTexture(32, 32, pixels);
    expect(kindOf(png)).toBe(kind);
    expect(decodeImage(png, 'a.png').data).toEqual(pixels);
    expect(png.length).toBeLessThanOrEqual(encodePng(32, 32, pixels).length);
  });
});
