import fc from 'fast-check';
import { expect, it } from 'vitest';
import { uniform } from '../../../../tests/support/physicsArbitraries.ts';
import type { Texture } from '../../../scene/types.ts';
import { fromSpecularGlossiness, metallicOf } from './specularGlossiness.ts';

const texture = (...data: readonly number[]): Texture => ({
  name: 't',
  width: data.length / 4,
  height: 1,
  data: Uint8Array.from(data),
  colorSpace: 'srgb',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'repeat',
});

it('keeps the grey metallic-roughness materials that it came from: diffuse = c (1 − m) 0.96/(1 − s), specular = 0.04 (1 − m) + c m', () => {
  fc.assert(
    fc.property(uniform(0.05, 1), uniform(0, 0.98), (c, m) => {
      const specular = 0.04 * (1 - m) + c * m;
      // What the metallic-roughness model scatters is c (1 − m); the extension multiplies its diffuse colour by 1 − s.
      const diffuse = (c * (1 - m) * 0.96) / (1 - specular);
      const { baseColor, metallic } = metallicOf({
        diffuse: [diffuse, diffuse, diffuse],
        specular: [specular, specular, specular],
      });
      // The rule solves for metalness first, then mixes by its square: exact at the ends, near between.
      expect(Math.abs(metallic - m)).toBeLessThan(1e-6);
      expect(Math.abs(baseColor[0] - c)).toBeLessThan(1e-6);
    }),
  );
});

it('converts texel by texel, at the size of the larger texture', () => {
  const { baseColorTexture, metallicTexture, roughnessTexture } = fromSpecularGlossiness({
    diffuse: [1, 1, 1],
    specular: [1, 1, 1],
    glossiness: 0.5,
    diffuseTexture: texture(0, 0, 0, 128),
    // Gold, and a black that reflects nothing: a dielectric.
    specularTexture: texture(255, 230, 150, 255, 0, 0, 0, 102),
  });
  expect([...baseColorTexture!.data]).toEqual([255, 230, 150, 128, 0, 0, 0, 128]);
  expect([metallicTexture!.texture.data[2], metallicTexture!.texture.data[6]]).toEqual([255, 0]);
  // 1 − glossiness · alpha.
  expect([roughnessTexture!.texture.data[1], roughnessTexture!.texture.data[5]]).toEqual([128, 204]);
});
