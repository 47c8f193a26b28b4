import type { Texture, TextureChannel, TextureWrap } from '../../scene/types.ts';
import { textureKey } from './textures.ts';

/** Channels of a texel. */
const TEXEL_CHANNELS = 4;

/**
 * Packs the channels that a material reads from several textures into few textures: together with those of lights, a shader would need more textures than
 * every device has. Textures of different sizes are enlarged to the largest. Textures that differ in wrapping or filtering, or are not linear, stay separate.
 */
export class ChannelPacker {
  private readonly cache = new Map<string, Texture>();

  pack<Name extends string>(channels: Partial<Record<Name, TextureChannel>>): Partial<Record<Name, TextureChannel>> {
    const groups = new Map<string, [Name, TextureChannel][]>();
    for (const [name, from] of Object.entries(channels) as [Name, TextureChannel][]) {
      const key = packingKey(from.texture);
      groups.set(key, [...(groups.get(key) ?? []), [name, from]]);
    }
    return Object.fromEntries([...groups.values()].flatMap((group) => this.packGroup(group))) as typeof channels;
  }

  private packGroup<Name>(group: readonly (readonly [Name, TextureChannel])[]): (readonly [Name, TextureChannel])[] {
    const pictures = new Set(group.map(([, { texture }]) => textureKey(texture)));
    if (pictures.size === 1) return [...group];
    return group.map(([name, from], i) => {
      const first = i - (i % TEXEL_CHANNELS);
      const texture = this.cachedTexture(group.slice(first, first + TEXEL_CHANNELS).map(([, channel]) => channel));
      return [name, { ...from, texture, channel: (i % TEXEL_CHANNELS) as TextureChannel['channel'] }];
    });
  }

  private cachedTexture(parts: readonly TextureChannel[]): Texture {
    const key = parts.map(({ texture, channel }) => `${textureKey(texture)} ${channel}`).join();
    const texture = this.cache.get(key) ?? packTexture(parts);
    this.cache.set(key, texture);
    return texture;
  }
}

/** Equal for textures whose channels can be packed together. Textures whose texels or borders must keep their size only match the same size. */
function packingKey(texture: Texture): string {
  const { colorSpace, filter, wrapS, wrapT, width, height } = texture;
  if (colorSpace !== 'linear') return textureKey(texture);
  const sized = filter === 'nearest' || wrapS === 'black' || wrapT === 'black';
  return [filter, wrapS, wrapT, ...(sized ? [width, height] : [])].join(' ');
}

function packTexture(parts: readonly TextureChannel[]): Texture {
  const [{ texture }] = parts;
  const width = Math.max(...parts.map((part) => part.texture.width));
  const height = Math.max(...parts.map((part) => part.texture.height));
  const data = new Uint8Array(TEXEL_CHANNELS * width * height);
  parts.forEach((part, k) => {
    const texelAt = resized(part, width, height);
    for (let y = 0, i = k; y < height; y++)
      for (let x = 0; x < width; x++, i += TEXEL_CHANNELS) data[i] = texelAt(x, y);
  });
  return { ...texture, name: parts.map((part) => part.texture.name).join(' + '), width, height, data };
}

/** The texels of a texture's channel, enlarged by linear interpolation. */
function resized(
  { texture, channel }: TextureChannel,
  width: number,
  height: number,
): (x: number, y: number) => number {
  const { data, width: w, height: h, wrapS, wrapT } = texture;
  if (w === width && h === height) return (x, y) => data[TEXEL_CHANNELS * (y * w + x) + channel];
  const texel = (x: number, y: number) =>
    data[TEXEL_CHANNELS * (wrapped(y, h, wrapT) * w + wrapped(x, w, wrapS)) + channel];
  return (x, y) => {
    const [u, v] = [((x + 0.5) * w) / width - 0.5, ((y + 0.5) * h) / height - 0.5];
    const [i, j] = [Math.floor(u), Math.floor(v)];
    const row = (k: number) => texel(i, k) + (u - i) * (texel(i + 1, k) - texel(i, k));
    return Math.round(row(j) + (v - j) * (row(j + 1) - row(j)));
  };
}

/** Wraps an index that is at most one beyond the ends. */
function wrapped(i: number, size: number, wrap: TextureWrap): number {
  if (wrap === 'repeat') return (i + size) % size;
  return Math.min(Math.max(i, 0), size - 1);
}
