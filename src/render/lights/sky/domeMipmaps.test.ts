import fc from 'fast-check';
import { expect, it } from 'vitest';
import { fromHalf, toHalf } from '../../../math/half.ts';
import type { RadianceTexture, Texture } from '../../../scene/types.ts';
import { type DomeLevel, domeMipmaps } from './domeMipmaps.ts';

const WRAP = { filter: 'linear', wrapS: 'repeat', wrapT: 'clamp' } as const;

/** A grey picture of radiance by (row, column). */
const picture = (width: number, height: number, value: (y: number, x: number) => number): RadianceTexture => ({
  ...{ name: 'dome', width, height, colorSpace: 'linear', ...WRAP },
  data: Uint16Array.from({ length: 4 * width * height }, (_, i) =>
    toHalf(i % 4 === 3 ? 1 : value(Math.floor((i >> 2) / width), (i >> 2) % width)),
  ),
});

const at = ({ data, width }: DomeLevel, y: number, x: number): number => fromHalf(data[4 * (y * width + x)]);

/** Mean over the sphere. */
function mean(level: DomeLevel): number {
  let [sum, whole] = [0, 0];
  for (let y = 0; y < level.height; y++) {
    const area = Math.sin((Math.PI * (y + 0.5)) / level.height);
    for (let x = 0; x < level.width; x++) sum += (area * at(level, y, x)) / level.width;
    whole += area;
  }
  return sum / whole;
}

it('each level is half as large as the one before, down to one texel, and the first is the picture', () => {
  const whole = picture(20, 7, () => 0);
  const levels = domeMipmaps(whole);
  expect(levels.map(({ width, height }) => [width, height])).toEqual([
    [20, 7],
    [10, 3],
    [5, 1],
    [2, 1],
    [1, 1],
  ]);
  expect(levels[0].data).toBe(whole.data);
});

it('an even sky stays even, whatever its size', () => {
  fc.assert(
    fc.property(fc.integer({ min: 1, max: 40 }), fc.integer({ min: 1, max: 40 }), (width, height) => {
      const texels = domeMipmaps(picture(width, height, () => 3)).flatMap(({ data }) => [...data]);
      expect(texels.filter((bits, i) => Math.abs(fromHalf(bits) - (i % 4 === 3 ? 1 : 3)) > 0.002)).toEqual([]);
    }),
    { numRuns: 30 },
  );
});

it('the light of all directions stays', () => {
  const levels = domeMipmaps(picture(128, 64, (y, x) => 1 + ((7 * x + 5 * y) % 11) + (y < 9 ? 20 : 0)));
  const [whole] = levels.map(mean);
  for (const level of levels.slice(0, 5)) expect(Math.abs(mean(level) / whole - 1)).toBeLessThan(0.01);
});

it('a mean is as wide as it is high: near a pole it is that of many texels of a row', () => {
  const [W, H] = [256, 128];
  for (const row of [3, 20, 64]) {
    const [, level] = domeMipmaps(picture(W, H, (_, x) => (x === 0 || x === 1 ? 1 : 0)));
    const y = row >> 1;
    const sums = Array.from({ length: level.width }, (_, x) => at(level, y, x));
    // The standard deviation of a box is its width/√12; a little is added by what neighbours share.
    const offset = (x: number): number => (x > level.width / 2 ? x - level.width : x);
    const total = sums.reduce((a, b) => a + b, 0);
    const variance = sums.reduce((sum, value, x) => sum + value * offset(x) ** 2, 0) / total;
    const radians = (Math.sqrt(12 * variance) * 2 * Math.PI) / level.width;
    const wide = radians * Math.sin((Math.PI * (y + 0.5)) / level.height);
    if (row < 64) expect(wide / (Math.PI / level.height)).toBeCloseTo(1, 0);
    else expect(sums.filter((value) => value > 0.1)).toHaveLength(1);
  }
});

it('what crosses the edge of the picture goes on at its other side', () => {
  const levels = domeMipmaps(picture(64, 32, (_, x) => (x === 0 || x === 63 ? 1 : 0)));
  for (const level of levels.slice(1, 4))
    for (let y = 0; y < level.height; y++)
      for (let x = 0; x < level.width; x++) expect(at(level, y, x)).toBeCloseTo(at(level, y, level.width - 1 - x), 2);
});

it('bytes are means of light, not of bytes', () => {
  const of = (colorSpace: Texture['colorSpace']): number => {
    const data = Uint8Array.from({ length: 16 }, (_, i) => (i % 4 === 3 || i % 8 < 4 ? 255 : 0));
    return domeMipmaps({ name: 'two', width: 4, height: 1, data, colorSpace, ...WRAP }).at(-1)!.data[0];
  };
  // IEC 61966-2-1: half of white is 188 of 255.
  expect(of('srgb')).toBe(188);
  expect(of('linear')).toBe(128);
});
