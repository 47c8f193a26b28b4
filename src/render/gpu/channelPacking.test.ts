import { describe, expect, it } from 'vitest';
import type { Texture, TextureChannel } from '../../scene/types.ts';
import { ChannelPacker } from './channelPacking.ts';

/** Each channel of each texel is another number. */
const picture = (seed: number, given: Partial<Texture> = {}): Texture => {
  const { width = 4, height = 2 } = given;
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
    ...given,
  };
};
const of = (texture: Texture, channel: TextureChannel['channel']): TextureChannel => ({
  texture,
  channel,
  scale: 2,
  bias: 0.1,
});
const texelsOf = ({ texture: { data }, channel }: TextureChannel): number[] =>
  Array.from(data).filter((_, i) => i % 4 === channel);

describe('channels of several pictures', () => {
  it('come together, texel by texel, four in each', () => {
    const all = {
      a: of(picture(1), 0),
      b: of(picture(2), 3),
      c: of(picture(3), 1),
      d: of(picture(4), 1),
      e: of(picture(5), 2),
    };
    const made = new ChannelPacker().pack(all);
    expect(new Set(Object.values(made).map(({ texture }) => texture)).size).toBe(2);
    for (const name of Object.keys(all) as (keyof typeof all)[]) {
      expect(texelsOf(made[name]!)).toEqual(texelsOf(all[name]));
      expect(made[name]).toMatchObject({ scale: 2, bias: 0.1 });
    }
  });

  it('are put together once for all materials', () => {
    const pictures = new ChannelPacker();
    const [a, b] = [picture(1), picture(2)];
    const [first, second] = [0, 1].map(() => pictures.pack({ a: of(a, 0), b: of(b, 0) }));
    expect(first.a!.texture).toBe(second.b!.texture);
  });

  it('stay where they are in one picture already', () => {
    const one = picture(1);
    expect(new ChannelPacker().pack({ a: of(one, 0), b: of(one, 1) }).a!.texture).toBe(one);
  });

  it.each([{ wrapS: 'mirror' }, { colorSpace: 'srgb' }, { filter: 'nearest' }] as const)(
    'stay apart where one is read otherwise: %o',
    (given) => {
      const [plain, other] = [picture(1), picture(2, given)];
      const made = new ChannelPacker().pack({ a: of(plain, 0), b: of(other, 0) });
      expect([made.a!.texture, made.b!.texture]).toEqual([plain, other]);
    },
  );

  it('become as large as the largest, and a ramp stays one', () => {
    const ramp = picture(0, {
      width: 4,
      height: 1,
      data: Uint8Array.from([40, 80, 120, 160].flatMap((x) => [x, 0, 0, 0])),
    });
    const made = new ChannelPacker().pack({ a: of(ramp, 0), b: of(picture(1, { width: 8, height: 2 }), 0) });
    // Texels of half the size are a quarter beside the middles of the old ones; the first is between the last and itself, for the picture repeats.
    const row = [70, 50, 70, 90, 110, 130, 150, 130];
    expect(texelsOf(made.a!)).toEqual([...row, ...row]);
  });
});
