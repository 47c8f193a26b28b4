import { describe, expect, it } from 'vitest';
import type { Texture } from '../types.ts';
import { sampleTexture } from './sampleTexture.ts';

/** Two texels across, one up: black and white, the second half clear. */
const pair = (given: Partial<Texture> = {}): Texture => ({
  name: 'pair',
  width: 2,
  height: 1,
  data: Uint8Array.of(0, 0, 0, 255, 255, 255, 255, 127),
  colorSpace: 'linear',
  filter: 'nearest',
  wrapS: 'repeat',
  wrapT: 'repeat',
  ...given,
});
const red = (texture: Texture, u: number): number => sampleTexture(texture, u, 0.5)[0];

describe('a texture', () => {
  it('follows its wrap modes', () => {
    const at = [-0.75, -0.25, 0.25, 0.75, 1.25, 1.75];
    expect(at.map((u) => red(pair(), u))).toEqual([0, 1, 0, 1, 0, 1]);
    expect(at.map((u) => red(pair({ wrapS: 'mirror' }), u))).toEqual([1, 0, 0, 1, 1, 0]);
    expect(at.map((u) => red(pair({ wrapS: 'clamp' }), u))).toEqual([0, 0, 0, 1, 1, 1]);
  });

  it('with wrap mode black fades to transparent black over one texel', () => {
    const bright = { data: Uint8Array.of(255, 0, 0, 255, 255, 0, 0, 255), wrapS: 'black' } as const;
    expect(sampleTexture(pair(bright), 1.01, 0.5)).toEqual([0, 0, 0, 0]);
    expect([-0.25, 0, 0.125, 0.25, 1].map((u) => red(pair({ ...bright, filter: 'linear' }), u))).toEqual([
      0, 0.5, 0.75, 1, 0.5,
    ]);
  });

  it('is decoded before it is blended', () => {
    const srgb = pair({ filter: 'linear', colorSpace: 'srgb' });
    expect(red(srgb, 0.25)).toBe(0);
    expect(red(srgb, 0.5)).toBeCloseTo(0.5, 15);
    // The repeated row: halfway across the seam.
    expect(red(srgb, 1)).toBeCloseTo(0.5, 15);
    // Mid grey, byte 188, is 0.5029 of linear light.
    const gray = pair({ colorSpace: 'srgb', data: Uint8Array.of(188, 188, 188, 255, 188, 188, 188, 255) });
    expect(red(gray, 0.3)).toBeCloseTo(0.5029, 4);
  });

  it('has its first row at the top', () => {
    const column = pair({ width: 1, height: 2 });
    expect(sampleTexture(column, 0.5, 0.75)[0]).toBe(0);
    expect(sampleTexture(column, 0.5, 0.25)).toEqual([1, 1, 1, 127 / 255]);
  });
});
