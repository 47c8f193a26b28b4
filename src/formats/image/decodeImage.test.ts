import { readFileSync } from 'node:fs';
import { crc32, deflateSync } from 'node:zlib';
import { encode } from 'jpeg-js';
import { describe, expect, it } from 'vitest';
import { InputError } from '../../scene/types.ts';
import { decodeImage } from './decodeImage.ts';
import { encodePng } from './encodePng.ts';

function chunk(type: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const out = Buffer.alloc(body.length + 8);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc32(body), body.length + 4);
  return out;
}

type Extra = Readonly<Record<string, readonly number[]>>;

/** A manually assembled PNG (PNG specification, third edition) with unfiltered rows. */
function png(
  width: number,
  height: number,
  depth: number,
  colorType: number,
  rows: readonly number[][],
  extra: Extra = {},
  interlace = 0,
): Uint8Array {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([depth, colorType, 0, 0, interlace], 8);
  const data = deflateSync(Uint8Array.from(rows.flatMap((row) => [0, ...row])));
  return Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    chunk('IHDR', header),
    ...Object.entries(extra).map(([type, bytes]) => chunk(type, Uint8Array.from(bytes))),
    chunk('IDAT', data),
    chunk('IEND', new Uint8Array(0)),
  ]);
}

const pixels = (bytes: Uint8Array): number[][] => {
  const { width, height, data } = decodeImage(bytes, 'a.png');
  expect(data.length).toBe(width * height * 4);
  return Array.from({ length: width * height }, (_, i) => [...data.subarray(i * 4, i * 4 + 4)]);
};
const gray = (v: number, alpha = 255): number[] => [v, v, v, alpha];

describe('PNG', () => {
  it('packed greys of 1, 2 and 4 bits', () => {
    expect(pixels(png(9, 1, 1, 0, [[0b10110000, 0b10000000]]))).toEqual(
      [1, 0, 1, 1, 0, 0, 0, 0, 1].map((b) => gray(b * 255)),
    );
    expect(pixels(png(3, 2, 2, 0, [[0b00011000], [0b11100100]]))).toEqual(
      [0, 85, 170, 255, 170, 85].map((v) => gray(v)),
    );
    expect(pixels(png(3, 1, 4, 0, [[0x0f, 0x70]]))).toEqual([0, 255, 119].map((v) => gray(v)));
  });

  it('8 and 16 bits, with and without alpha', () => {
    expect(pixels(png(2, 1, 8, 0, [[7, 9]]))).toEqual([gray(7), gray(9)]);
    expect(pixels(png(1, 1, 8, 4, [[7, 100]]))).toEqual([gray(7, 100)]);
    expect(pixels(png(1, 1, 16, 0, [[0x80, 0x80]]))).toEqual([gray(128)]);
    expect(pixels(png(1, 1, 16, 4, [[0xff, 0xff, 0x40, 0x40]]))).toEqual([gray(255, 64)]);
    expect(pixels(png(1, 1, 8, 2, [[1, 2, 3]]))).toEqual([[1, 2, 3, 255]]);
    expect(pixels(png(1, 1, 16, 2, [[1, 1, 2, 2, 255, 254]]))).toEqual([[1, 2, 255, 255]]);
    expect(pixels(png(1, 1, 16, 6, [[1, 1, 2, 2, 3, 3, 4, 4]]))).toEqual([[1, 2, 3, 4]]);
  });

  it('palettes, with alpha for the first colours', () => {
    const extra = { PLTE: [10, 20, 30, 40, 50, 60, 70, 80, 90], tRNS: [128] };
    expect(pixels(png(3, 1, 2, 3, [[0b00011000]], extra))).toEqual([
      [10, 20, 30, 128],
      [40, 50, 60, 255],
      [70, 80, 90, 255],
    ]);
    expect(() => decodeImage(png(1, 1, 8, 3, [[7]], extra), 'p.png')).toThrow(
      'p.png: the PNG is damaged or cut off (palette has no colour 7)',
    );
  });

  it('a transparent colour', () => {
    const rows = [[1, 2, 3, 1, 2, 4]];
    expect(pixels(png(2, 1, 8, 2, rows, { tRNS: [0, 1, 0, 2, 0, 3] }))).toEqual([
      [1, 2, 3, 0],
      [1, 2, 4, 255],
    ]);
    expect(pixels(png(2, 1, 8, 0, [[5, 6]], { tRNS: [0, 6] }))).toEqual([gray(5), gray(6, 0)]);
  });

  it('interlaced, also where pixels share a byte', () => {
    // Pixel (x, y) of 3 × 3 belongs to pass 1 (0, 0), 4 (2, 0), 5 (0, 2) (2, 2), 6 (1, 0) (1, 2), 7 (all of row 1).
    const passes = [[[1]], [[2]], [[3, 4]], [[5], [6]], [[7, 8, 9]]];
    const expected = [1, 5, 2, 7, 8, 9, 3, 6, 4];
    expect(pixels(png(3, 3, 8, 0, passes.flat(), {}, 1))).toEqual(expected.map((v) => gray(v)));
    const pack = (row: readonly number[]): number[] => [row.reduce((byte, v, i) => byte | ((v & 3) << (6 - 2 * i)), 0)];
    expect(pixels(png(3, 3, 2, 0, passes.flat().map(pack), {}, 1))).toEqual(expected.map((v) => gray((v & 3) * 85)));
  });

  it('needs no more memory than its size, for any content', () => {
    const bomb = png(2, 2, 8, 0, [new Array(3e5).fill(0)]);
    expect(pixels(bomb)).toEqual(new Array(4).fill(gray(0)));
  });

  it('reads pictures of encodePng', () => {
    const rgba = Uint8Array.from({ length: 13 * 7 * 4 }, (_, i) => (i * 73) & 255);
    expect(decodeImage(encodePng(13, 7, rgba), 'a.png')).toEqual({ width: 13, height: 7, data: rgba });
    expect(() => encodePng(2, 2, rgba)).toThrow('2 × 2 has 16 bytes');
  });
});

describe('JPEG', () => {
  const squares: readonly [number, number, number[]][] = [
    [8, 8, [220, 30, 40]],
    [24, 8, [20, 200, 60]],
    [8, 24, [30, 40, 210]],
    [24, 24, [128, 128, 128]],
  ];
  const read = (name: string) => decodeImage(readFileSync(new URL(`./testdata/${name}`, import.meta.url)), name);

  it.each(['squares.jpg', 'squares-progressive.jpg', 'squares-grey.jpg'])('%s', (name) => {
    const { width, height, data } = read(name);
    expect([width, height, data.length]).toEqual([32, 32, 4096]);
    for (const [x, y, [r, g, b]] of squares) {
      const [at, luma] = [(y * 32 + x) * 4, 0.299 * r + 0.587 * g + 0.114 * b];
      const expected = name.includes('grey') ? [luma, luma, luma, 255] : [r, g, b, 255];
      for (let k = 0; k < 4; k++) expect(Math.abs(data[at + k] - expected[k])).toBeLessThan(5);
    }
  });
});

describe('an unreadable picture', () => {
  const rgba = Uint8Array.from({ length: 400 }, (_, i) => (i * 91) & 255);
  const samples = {
    'a.png': encodePng(10, 10, rgba),
    'a.jpg': new Uint8Array(readFileSync(new URL('./testdata/squares.jpg', import.meta.url))),
  };

  it.each(Object.entries(samples))('%s truncated or with flipped bits is read or an InputError', (name, bytes) => {
    const attempt = (broken: Uint8Array): unknown => {
      try {
        decodeImage(broken, name);
        return undefined;
      } catch (error) {
        return error;
      }
    };
    for (let n = 0; n < bytes.length - 1; n++) expect(attempt(bytes.subarray(0, n))).toBeInstanceOf(InputError);
    for (let i = 0; i < bytes.length; i++) {
      const error = attempt(bytes.with(i, bytes[i] ^ (1 << (i % 8))));
      if (error !== undefined) expect(error).toBeInstanceOf(InputError);
    }
  });

  it('is rejected with a remedy', () => {
    const say = (bytes: Uint8Array): string => {
      try {
        decodeImage(bytes, 'wood');
      } catch (error) {
        return (error as Error).message;
      }
      return 'read';
    };
    const latin = (text: string): Uint8Array => Uint8Array.from(Buffer.from(text, 'latin1'));
    expect(say(new Uint8Array(0))).toBe('wood: the picture is empty (0 bytes); copy it again');
    expect(say(latin('RIFF1234WEBPVP8 '))).toBe(
      'wood: the picture is WebP, which is not read; convert it to PNG or JPEG',
    );
    expect(say(latin('GIF89a'))).toBe('wood: the picture is neither PNG nor JPEG; convert it to PNG or JPEG');
    const wide = png(70000, 1, 8, 0, [[0]]);
    expect(say(wide)).toBe(
      'wood: the picture is 70000 × 1 pixels, 1 to 16384 a side and at most 64 Mi pixels are read; scale it',
    );
  });
});

describe('JPEG of red, green and blue, or of luma and chroma', () => {
  /** Written as Y, Cb and Cr (ITU T.871), behind the segments that are given in place of JFIF's. */
  const jpeg = (color: readonly number[], segments: readonly number[], ids?: string): Uint8Array => {
    const size = 8;
    const data = Uint8Array.from({ length: 4 * size * size }, (_, k) => color[k % 4] ?? 255);
    const bytes = [...encode({ width: size, height: size, data }, 100).data];
    bytes.splice(2, 2 + ((bytes[4] << 8) | bytes[5]), ...segments);
    const frame = bytes.findIndex((byte, k) => byte === 0xff && bytes[k + 1] === 0xc0);
    const scan = bytes.findIndex((byte, k) => byte === 0xff && bytes[k + 1] === 0xda);
    for (const [k, id] of [...(ids ?? '')].entries())
      bytes[frame + 10 + 3 * k] = bytes[scan + 5 + 2 * k] = id.charCodeAt(0);
    return Uint8Array.from(bytes);
  };
  const adobe = (transform: number): number[] => [
    0xff,
    0xee,
    0,
    14,
    ...Buffer.from('Adobe'),
    0,
    100,
    0,
    0,
    0,
    0,
    transform,
  ];
  const [r, g, b] = [200, 120, 40];
  const luma = 0.299 * r + 0.587 * g + 0.114 * b;
  const stored = [luma, 128 + (b - luma) / 1.772, 128 + (r - luma) / 1.402];

  it.each([
    ['without a word', [], undefined, [r, g, b]],
    ['that say so', adobe(1), undefined, [r, g, b]],
    ['of components R, G and B', [], 'RGB', stored],
    ['that say that they are RGB', adobe(0), undefined, stored],
  ] as const)('colours of files %s', (_, segments, ids, expected) => {
    for (const [k, value] of decodeImage(jpeg([r, g, b], segments, ids), 'a.jpg')
      .data.subarray(0, 3)
      .entries())
      expect(Math.abs(value - expected[k])).toBeLessThan(2);
  });
});
