import type { Texture, TextureChannel, TextureWrap } from '../../scene/types.ts';
import { textureKey } from './textures.ts';

/** Of a picture's texel. */
const TEXEL_CHANNELS = 4;

/**
 * Puts the channels that a material takes from several pictures into few pictures: with what a light needs a shader would have more textures than every device has. Pictures of
 * different sizes become as large as the largest. Left as they are: what another wraps or filters otherwise, and what is not linear.
 */
export class ChannelPacker {
  private readonly made = new Map<string, Texture>();

  pack<Name extends string>(of: Partial<Record<Name, TextureChannel>>): Partial<Record<Name, TextureChannel>> {
    const groups = new Map<string, [Name, TextureChannel][]>();
    for (const [name, from] of Object.entries(of) as [Name, TextureChannel][]) {
      const alike = packingKey(from.texture);
      groups.set(alike, [...(groups.get(alike) ?? []), [name, from]]);
    }
    return Object.fromEntries([...groups.values()].flatMap((group) => this.packGroup(group))) as typeof of;
  }

  private packGroup<Name>(group: readonly (readonly [Name, TextureChannel])[]): (readonly [Name, TextureChannel])[] {
    const pictures = new Set(group.map(([, { texture }]) => textureKey(texture)));
    if (pictures.size === 1) return [...group];
    return group.map(([name, from], i) => {
      const first = i - (i % TEXEL_CHANNELS);
      const texture = this.cachedTexture(group.slice(first, first + TEXEL_CHANNELS).map(([, each]) => each));
      return [name, { ...from, texture, channel: (i % TEXEL_CHANNELS) as TextureChannel['channel'] }];
    });
  }

  private cachedTexture(parts: readonly TextureChannel[]): Texture {
    const key = parts.map(({ texture, channel }) => `${textureKey(texture)} ${channel}`).join();
    const texture = this.made.get(key) ?? packTexture(parts);
    this.made.set(key, texture);
    return texture;
  }
}

/** The same for pictures of which channels can be put together. Texels that are to be seen, and borders, keep their size. */
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
    const at = resized(part, width, height);
    for (let y = 0, i = k; y < height; y++) for (let x = 0; x < width; x++, i += TEXEL_CHANNELS) data[i] = at(x, y);
  });
  return { ...texture, name: parts.map((part) => part.texture.name).join(' + '), width, height, data };
}

/** The texels of a channel of a picture that is made larger, linear between those it has. */
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

/** A place that is at most one beyond the ends. */
function wrapped(i: number, size: number, wrap: TextureWrap): number {
  if (wrap === 'repeat') return (i + size) % size;
  return Math.min(Math.max(i, 0), size - 1);
}
