import { expect, it } from 'vitest';
import { writeExr } from '../exr.ts';
import { decodeFloatPicture } from './floatPicture.ts';

const exr = (channels: Readonly<Record<string, readonly number[]>>): Uint8Array =>
  writeExr({
    width: 2,
    height: 1,
    channels: Object.entries(channels).map(([name, data]) => ({ name, type: 'float', data: Float32Array.from(data) })),
  });

it('linear light is encoded for textures, and cut at white; numbers stay numbers', () => {
  const picture = decodeFloatPicture(exr({ R: [0.5, 3], G: [0.0031308, -1], B: [1, Number.NaN] }), 'a.exr');
  // IEC 61966-2-1: 0.5 is 0.7354 × 255, 0.0031308 is 0.04045 × 255.
  expect([...picture!.data]).toEqual([188, 10, 255, 255, 255, 0, 0, 255]);
  expect([...picture!.numbers]).toEqual([128, 1, 255, 255, 255, 0, 0, 255]);
});

it('alpha is straight; one channel is grey', () => {
  const covered = decodeFloatPicture(exr({ R: [0.25, 0], G: [0, 0], B: [0.125, 0], A: [0.5, 0] }), 'a.exr');
  expect([...covered!.numbers]).toEqual([128, 0, 64, 128, 0, 0, 0, 0]);
  expect([...decodeFloatPicture(exr({ roughness: [0.2, 1] }), 'a.exr')!.numbers]).toEqual([
    51, 51, 51, 255, 255, 255, 255, 255,
  ]);
});

it('others are not its business, and channels of something else are refused', () => {
  expect(decodeFloatPicture(Uint8Array.of(0x89, 0x50), 'a.png')).toBeUndefined();
  expect(() => decodeFloatPicture(exr({ X: [0, 0], Z: [0, 0] }), 'a.exr')).toThrow(/a\.exr: .*it has X/);
});
