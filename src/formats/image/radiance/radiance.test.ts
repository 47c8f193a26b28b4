import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fromHalf } from '../../../math/half.ts';
import { InputError } from '../../../scene/types.ts';
import { writeExr } from '../exr.ts';
import { decodeRadiance, encodeRadiance } from './radiance.ts';

const header = (size: string, lines: readonly string[] = ['FORMAT=32-bit_rle_rgbe']): number[] => [
  ...new TextEncoder().encode(`#?RADIANCE\n# by hand\n${lines.join('\n')}\n\n${size}\n`),
];
const read = (...bytes: readonly (readonly number[])[]) => decodeRadiance(Uint8Array.from(bytes.flat()), 'sky.hdr')!;
const pixel = ({ data }: { readonly data: Uint16Array }, i: number): number[] =>
  [0, 1, 2].map((k) => fromHalf(data[4 * i + k]));
const about = (...v: readonly number[]) => v.map((x) => expect.closeTo(x, 2));

describe('a Radiance picture', () => {
  // 2 ^ (129 − 136) = 1/128: (128 + ½)/128 and (64 + ½)/128.
  const RED = [128, 64, 0, 129];
  const DARK = [0, 0, 0, 0];

  it('is read uncompressed, from the top or from the bottom', () => {
    const flat = read(header('-Y 2 +X 1'), RED, DARK);
    expect(flat).toMatchObject({ width: 1, height: 2 });
    expect(pixel(flat, 0)).toEqual(about(1, 0.5, 0));
    expect(pixel(flat, 1)).toEqual([0, 0, 0]);
    expect(pixel(read(header('+Y 2 +X 1'), RED, DARK), 1)).toEqual(about(1, 0.5, 0));
  });

  it('is read with run-length encoded components', () => {
    const packed = [2, 2, 0, 8, 128 + 8, 128, 4, 64, 32, 16, 8, 128 + 4, 0, 128 + 8, 0, 128 + 8, 129];
    const image = read(header('-Y 1 +X 8'), packed);
    expect(pixel(image, 7)).toEqual(about(1, 0, 0));
    expect(pixel(image, 1)).toEqual(about(1, 0.25, 0));
  });

  it('is read with old run-length encoding', () => {
    const image = read(header('-Y 1 +X 301'), RED, [1, 1, 1, 44], [1, 1, 1, 1]);
    expect(pixel(image, 300)).toEqual(about(1, 0.5, 0));
  });

  it('keeps its hue where it is brighter than halves', () => {
    const [red, green, blue] = pixel(read(header('-Y 1 +X 1'), [200, 100, 50, 160]), 0);
    expect(red).toBe(65504);
    expect([green / red, blue / red]).toEqual([expect.closeTo(100.5 / 200.5, 3), expect.closeTo(50.5 / 200.5, 3)]);
  });

  it('is divided by its exposures, and clamped to the range of halves', () => {
    const image = read(header('-Y 1 +X 2', ['EXPOSURE=2', 'EXPOSURE= 0.25']), RED, [255, 0, 0, 255]);
    expect(pixel(image, 0)[0]).toBeCloseTo(2, 1);
    expect(pixel(image, 1)[0]).toBe(65504);
  });

  it.each([
    ['one that is cut off', header('-Y 4 +X 1'), 'image.damaged'],
    ['one larger than its bytes can be', header('-Y 8000 +X 4000'), 'image.damaged'],
    ['one larger than is read', header('-Y 99999 +X 99999'), 'image.size'],
    ['another color space', header('-Y 1 +X 1', ['FORMAT=32-bit_rle_xyze']), 'image.unsupported'],
    ['rows that are columns', header('+X 1 -Y 1'), 'image.unsupported'],
    ['an exposure that is no number', [...header('-Y 1 +X 1', ['EXPOSURE=much']), ...RED], 'image.damaged'],
    ['an exposure of 0', [...header('-Y 1 +X 1', ['EXPOSURE=0']), ...RED], 'image.damaged'],
    ['a run without a pixel', [...header('-Y 1 +X 2'), 1, 1, 1, 2, ...RED], 'image.damaged'],
    ['a header without an end', [...new TextEncoder().encode('#?RADIANCE\na')], 'image.damaged'],
  ])('rejects %s', (_, bytes, code) => {
    const refusal = expect.objectContaining({ diagnostic: expect.objectContaining({ code, place: 'sky.hdr' }) });
    expect(() => read(bytes)).toThrow(refusal);
  });

  it('with any damage is read or rejected', () => {
    const whole = [...header('-Y 2 +X 8'), ...Array(2).fill([2, 2, 0, 8, 136, 9, 136, 8, 136, 7, 136, 129]).flat()];
    fc.assert(
      fc.property(fc.nat(whole.length - 1), fc.nat(255), fc.nat(whole.length), (place, byte, length) => {
        const bytes = whole.with(place, byte).slice(0, length);
        try {
          const found = decodeRadiance(Uint8Array.from(bytes), 'sky.hdr');
          for (const bits of found?.data ?? []) expect(Number.isFinite(fromHalf(bits))).toBe(true);
        } catch (thrown) {
          expect(thrown).toBeInstanceOf(InputError);
        }
      }),
    );
  });
});

describe('an OpenEXR picture of radiance', () => {
  const exr = (names: string, ...values: readonly number[]) =>
    writeExr({
      width: values.length,
      height: 1,
      channels: [...names].map((name) => ({ name, type: 'float' as const, data: Float32Array.from(values) })),
    });

  it('is clamped to 0 … the largest half, without NaN', () => {
    const image = decodeRadiance(exr('RGB', 0.5, -1, Number.NaN, 1e9, Number.POSITIVE_INFINITY), 'a.exr')!;
    expect([0, 1, 2, 3, 4].map((i) => pixel(image, i)[1])).toEqual([0.5, 0, 0, 65504, 65504]);
  });

  it('keeps its hue where it is brighter than halves', () => {
    const channels = [4e6, 1e6, 2e6].map((value, k) => ({
      name: 'RGB'[k],
      type: 'float' as const,
      data: Float32Array.of(value),
    }));
    const image = decodeRadiance(writeExr({ width: 1, height: 1, channels }), 'a.exr')!;
    expect(pixel(image, 0)).toEqual([65504, 16376, 32752]);
  });

  it('may have a single channel', () => {
    expect(pixel(decodeRadiance(exr('Y', 7), 'a.exr')!, 0)).toEqual([7, 7, 7]);
    expect(() => decodeRadiance(exr('Z', 7), 'a.exr')).toThrow(/it has Z/);
  });

  it('round-trips', () => {
    const image = decodeRadiance(exr('RGB', 0.25, 1000, 65504), 'a.exr')!;
    expect(decodeRadiance(encodeRadiance(image), 'b.exr')).toEqual(image);
  });

  it('is not confused with other formats', () => {
    expect(decodeRadiance(Uint8Array.of(1, 2, 3), 'a')).toBeUndefined();
  });
});
