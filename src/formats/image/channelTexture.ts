import type { Texture, TextureChannel } from '../../scene/types.ts';
import { decodeSrgb } from '../../spectrum/display/srgb.ts';

/** Writes a texture channel into channel `to` of an RGBA image of the size of `like`, nearest texel. */
export function writeChannel(
  data: Uint8Array,
  like: Texture,
  to: number,
  { texture, channel, scale, bias }: TextureChannel,
): void {
  const isSrgb = texture.colorSpace === 'srgb' && channel < 3;
  const table = Uint8Array.from({ length: 256 }, (_, byte) => {
    const value = (isSrgb ? decodeSrgb(byte / 255) : byte / 255) * scale + bias;
    return Math.round(255 * Math.min(1, Math.max(0, value)));
  });
  for (let y = 0; y < like.height; y++) {
    const row = Math.floor((y * texture.height) / like.height) * texture.width;
    for (let x = 0; x < like.width; x++) {
      const from = row + Math.floor((x * texture.width) / like.width);
      data[4 * (y * like.width + x) + to] = table[texture.data[4 * from + channel]];
    }
  }
}

/** A texture channel as the red of a new texture. */
export function redTexture(from: TextureChannel): Texture {
  const data = new Uint8Array(from.texture.data.length).fill(255);
  writeChannel(data, from.texture, 0, from);
  return { ...from.texture, data, colorSpace: 'linear' };
}
