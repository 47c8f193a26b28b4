import { describe, expect, it } from 'vitest';
import type { Texture, TextureChannel } from '../../scene/types.ts';
import { ChannelPacker } from './channelPacking.ts';

/** A texture in which neighbouring channels and texels have different numbers. */
const makeTexture = (seed: number, overrides: Partial<Texture> = {}): Texture => {
  const { width = 4, height = 2 } = overrides;
  const data = Uint8Array.from({ length: 4 * width * height }, (_, i) => (37 * i + seed) % 256);
  return {
    name: `${seed}`,
    width,
    height,
    data,
    colorSpace: 'linear',
    filter: 'linear',
    wrapS: 'repeat',
    wrapT: 'clamp',
    ...overrides,
  };
};
const channelOf = (texture: Texture, channel: TextureChannel['channel']): TextureChannel => ({
  texture,
  channel,
  scale: 2,
  bias: 0.1,
});
const texelsOf = ({ texture: { data }, channel }: TextureChannel): number[] =>
  Array.from(data).filter((_, i) => i % 4 === channel);

describe('channels of several textures', () => {
  it('are packed texel by texel, four into one texture', () => {
    const channels = {
      a: channelOf(makeTexture(1), 0),
      b: channelOf(makeTexture(2), 3),
      c: channelOf(makeTexture(3), 1),
      d: channelOf(makeTexture(4), 1),
      e: channelOf(makeTexture(5), 2),
    };
    const packed = new ChannelPacker().pack(channels);
    expect(new Set(Object.values(packed).map(({ texture }) => texture)).size).toBe(2);
    for (const name of Object.keys(channels) as (keyof typeof channels)[]) {
      expect(texelsOf(packed[name]!)).toEqual(texelsOf(channels[name]));
      expect(packed[name]).toMatchObject({ scale: 2, bias: 0.1 });
    }
  });

  it('are packed once for all materials', () => {
    const packer = new ChannelPacker();
    const [a, b] = [makeTexture(1), makeTexture(2)];
    const [first, second] = [0, 1].map(() => packer.pack({ a: channelOf(a, 0), b: channelOf(b, 0) }));
    expect(first.a!.texture).toBe(second.b!.texture);
  });

  it('stay as they are if they are in one texture', () => {
    const source = makeTexture(1);
    expect(new ChannelPacker().pack({ a: channelOf(source, 0), b: channelOf(source, 1) }).a!.texture).toBe(source);
  });

  it.each([{ wrapS: 'mirror' }, { colorSpace: 'srgb' }, { filter: 'nearest' }] as const)(
    'stay separate if one is sampled differently: %o',
    (overrides) => {
      const [plain, other] = [makeTexture(1), makeTexture(2, overrides)];
      const packed = new ChannelPacker().pack({ a: channelOf(plain, 0), b: channelOf(other, 0) });
      expect([packed.a!.texture, packed.b!.texture]).toEqual([plain, other]);
    },
  );

  it('are enlarged to the largest size, and a ramp stays a ramp', () => {
    const ramp = makeTexture(0, {
      width: 4,
      height: 1,
      data: Uint8Array.from([40, 80, 120, 160].flatMap((x) => [x, 0, 0, 0])),
    });
    const packed = new ChannelPacker().pack({
      a: channelOf(ramp, 0),
      b: channelOf(makeTexture(1, { width: 8, height: 2 }), 0),
    });
    // Texels of half the size lie a quarter beside the centres of the old ones; the first is between the last and itself, because the texture repeats.
    const row = [70, 50, 70, 90, 110, 130, 150, 130];
    expect(texelsOf(packed.a!)).toEqual([...row, ...row]);
  });
});
