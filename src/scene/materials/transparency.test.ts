import { expect, it } from 'vitest';
import { makeMaterial } from '../defaults.ts';
import type { Texture } from '../types.ts';
import { isTransparent } from './transparency.ts';

const image = (alpha: number): Texture => ({
  name: 'image',
  width: 2,
  height: 1,
  data: new Uint8Array([9, 9, 9, 255, 9, 9, 9, alpha]),
  colorSpace: 'srgb',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'repeat',
});

it('a material is transparent by its opacity or texture, but not if it is cut out', () => {
  const plain = makeMaterial({ name: 'm' });
  expect(isTransparent(plain)).toBe(false);
  expect(isTransparent({ ...plain, opacity: 0.9 })).toBe(true);
  expect(isTransparent({ ...plain, baseColorTexture: image(255) })).toBe(false);
  expect(isTransparent({ ...plain, baseColorTexture: image(100) })).toBe(true);
  expect(isTransparent({ ...plain, baseColorTexture: image(100), opacityThreshold: 0.5 })).toBe(false);
});
