import type { Material, Texture, TextureChannel } from '../../../scene/types.ts';
import { redTexture, writeChannel } from '../../image/channelTexture.ts';

/** A combined texture, roughness in green and metalness in blue, with its factors. */
export interface MetallicRoughnessTexture {
  readonly texture: Texture;
  readonly roughness: number;
  readonly metallic: number;
}

/** Combines roughness and metalness textures; undefined if there are none. */
export function metallicRoughnessTexture(material: Material): MetallicRoughnessTexture | undefined {
  const { roughnessTexture: rough, metallicTexture: metal } = material;
  const texture = rough?.texture ?? metal?.texture;
  if (!texture) return undefined;
  if (rough && metal && rough.texture === metal.texture && isPlain(rough, 1) && isPlain(metal, 2))
    return { texture, roughness: rough.scale, metallic: metal.scale };
  const data = new Uint8Array(texture.data.length).fill(255);
  if (rough) writeChannel(data, texture, 1, rough);
  if (metal) writeChannel(data, texture, 2, metal);
  return {
    texture: { ...texture, data, colorSpace: 'linear' },
    roughness: rough ? 1 : material.roughness,
    metallic: metal ? 1 : material.metallic,
  };
}

/** Occlusion texture (red) and strength. */
export function occlusionTextureOf(from: TextureChannel): { readonly texture: Texture; readonly strength: number } {
  const { texture, scale, bias } = from;
  if (isPlain({ ...from, bias: 0 }, 0) && Math.abs(scale + bias - 1) < 1e-6) return { texture, strength: scale };
  return { texture: redTexture(from), strength: 1 };
}

const isPlain = ({ texture, channel, scale, bias }: TextureChannel, wanted: number): boolean =>
  texture.colorSpace === 'linear' && channel === wanted && bias === 0 && scale >= 0 && scale <= 1;

/** A texture with the numbers in channel `wanted`, and the factor to them. */
export function inChannel(
  from: TextureChannel,
  wanted: number,
): { readonly texture: Texture; readonly factor: number } {
  if (isPlain(from, wanted)) return { texture: from.texture, factor: from.scale };
  const data = new Uint8Array(from.texture.data.length).fill(255);
  writeChannel(data, from.texture, wanted, from);
  return { texture: { ...from.texture, data, colorSpace: 'linear' }, factor: 1 };
}
