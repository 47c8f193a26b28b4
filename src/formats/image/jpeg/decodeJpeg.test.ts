import { readFileSync } from 'node:fs';
import { decode, encode } from 'jpeg-js';
import { describe, expect, it } from 'vitest';
import { inEnglish } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { decodeJpeg } from './decodeJpeg.ts';

/** A component whose blocks have one value each, by column and row of blocks. */
interface FlatComponent {
  readonly id?: number;
  readonly across?: number;
  readonly down?: number;
  value(column: number, row: number): number;
}

interface FlatPicture {
  readonly width: number;
  readonly height: number;
  readonly components: readonly FlatComponent[];
  readonly restartInterval?: number;
  /** Segments before the frame, whole. */
  readonly segments?: readonly number[];
  /** A scan for each component, and for the last bit of its values. */
  readonly progressive?: boolean;
}

/** Codes of a scan: sizes of differences in 4 bits each, and one bit that ends a block. */
class CodeWriter {
  readonly bytes: number[] = [];
  private text = '';
  bits(value: number, size: number): void {
    if (size > 0) this.text += value.toString(2).padStart(size, '0');
  }
  difference(by: number): void {
    const size = by === 0 ? 0 : Math.floor(Math.log2(Math.abs(by))) + 1;
    this.bits(size, 4);
    this.bits(by < 0 ? by + 2 ** size - 1 : by, size);
  }
  /** Fills a byte with ones; a zero follows each byte of ones. */
  flush(): void {
    for (let i = 0; i < this.text.length; i += 8) {
      const byte = Number.parseInt(this.text.slice(i, i + 8).padEnd(8, '1'), 2);
      this.bytes.push(byte, ...(byte === 0xff ? [0] : []));
    }
    this.text = '';
  }
}

const segment = (marker: number, ...payload: readonly number[]): number[] => [
  0xff,
  marker,
  (payload.length + 2) >> 8,
  (payload.length + 2) & 255,
  ...payload,
];
const ADOBE = (transform: number): number[] => segment(0xee, ...Buffer.from('Adobe'), 0, 100, 0, 0, 0, 0, transform);

/** A JPEG of a few components, written here by ITU T.81; steps of 8 make a mean of n samples n brighter than 128. */
function jpegOf(picture: FlatPicture): Uint8Array {
  const { width, height, restartInterval = 0, segments = [], progressive = false } = picture;
  const components = picture.components.map((c, k) => ({ id: k + 1, across: 1, down: 1, ...c }));
  const most = {
    across: Math.max(...components.map((c) => c.across)),
    down: Math.max(...components.map((c) => c.down)),
  };
  const frame = components.flatMap(({ id, across, down }) => [id, 16 * across + down, 0]);
  const scan = (of: typeof components, [before, after]: readonly number[]): number[] => {
    const codes = new CodeWriter();
    const alone = of.length === 1;
    const blocks = (size: number, factor: number, whole: number): number =>
      alone ? Math.ceil(Math.ceil((size * factor) / whole) / 8) : Math.ceil(size / (8 * whole));
    const columns = blocks(width, of[0].across, most.across);
    const units = columns * blocks(height, of[0].down, most.down);
    let before_ = of.map(() => 0);
    for (let unit = 0; unit < units; unit++) {
      if (restartInterval > 0 && unit > 0 && unit % restartInterval === 0) {
        codes.flush();
        codes.bytes.push(0xff, 0xd0 + ((unit / restartInterval - 1) & 7));
        before_ = of.map(() => 0);
      }
      of.forEach(({ across, down, value }, k) => {
        for (let y = 0; y < (alone ? 1 : down); y++)
          for (let x = 0; x < (alone ? 1 : across); x++) {
            const column = (unit % columns) * (alone ? 1 : across) + x;
            const mean = value(column, Math.floor(unit / columns) * (alone ? 1 : down) + y) - 128;
            if (before > 0) codes.bits((mean >> after) & 1, 1);
            else {
              codes.difference((mean >> after) - before_[k]);
              before_[k] = mean >> after;
              if (!progressive) codes.bits(0, 1);
            }
          }
      });
    }
    codes.flush();
    const header = of.flatMap(({ id }) => [id, 0]);
    return [...segment(0xda, of.length, ...header, 0, progressive ? 0 : 63, 16 * before + after), ...codes.bytes];
  };
  const scans = progressive
    ? components.flatMap((c) => [...scan([c], [0, 1]), ...scan([c], [1, 0])])
    : scan(components, [0, 0]);
  const tables = [0, ...[0, 0, 0, 12, ...Array(12).fill(0)], ...Array(12).keys()];
  return Uint8Array.from([
    ...[0xff, 0xd8],
    ...segments,
    ...segment(0xdb, 0, ...Array(64).fill(8)),
    ...segment(0xc4, ...tables, 16, 1, ...Array(15).fill(0), 0),
    ...segment(0xdd, restartInterval >> 8, restartInterval & 255),
    ...segment(
      progressive ? 0xc2 : 0xc0,
      8,
      height >> 8,
      height & 255,
      width >> 8,
      width & 255,
      components.length,
      ...frame,
    ),
    ...scans,
    ...[0xff, 0xd9],
  ]);
}

const read = (bytes: Uint8Array) => decodeJpeg(bytes, () => {});
const pixel = ({ data, width }: ReturnType<typeof read>, x: number, y: number): number[] => [
  ...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3),
];
const GRAY = { value: () => 128 };

describe('a JPEG', () => {
  it.each([false, true])(
    'has its components at their own sizes, also with restarts (progressive: %s)',
    (progressive) => {
      const luma = (column: number, row: number): number => 20 + 9 * column + 20 * row;
      for (const [across, down] of [
        [1, 1],
        [2, 1],
        [1, 2],
        [2, 2],
        [4, 1],
      ])
        for (const restartInterval of [0, 1, 3]) {
          const picture = read(
            jpegOf({
              width: 61,
              height: 37,
              progressive,
              restartInterval,
              components: [{ across, down, value: luma }, GRAY, { value: (x, y) => 128 + 4 * x + 2 * y }],
            }),
          );
          expect([picture.width, picture.height, picture.data.length]).toEqual([61, 37, 4 * 61 * 37]);
          for (const [x, y] of [
            [0, 0],
            [60, 0],
            [17, 23],
            [60, 36],
          ]) {
            const bright = luma(Math.floor(x / 8), Math.floor(y / 8));
            const red = 4 * Math.floor(x / (8 * across)) + 2 * Math.floor(y / (8 * down));
            const expected = [bright + 1.402 * red, bright - 0.714136 * red, bright];
            pixel(picture, x, y).forEach((value, k) => {
              expect(Math.abs(value - expected[k])).toBeLessThan(1);
            });
          }
        }
    },
  );

  it('has the colours that Adobe, or the components’ names, say', () => {
    const of = (values: readonly number[], segments: readonly number[] = [], ids: readonly number[] = []): number[] =>
      pixel(
        read(
          jpegOf({
            width: 8,
            height: 8,
            segments,
            components: values.map((value, k) => ({ value: () => value, ...(ids[k] && { id: ids[k] }) })),
          }),
        ),
        3,
        5,
      );
    expect(of([77])).toEqual([77, 77, 77]);
    expect(of([100, 128, 128])).toEqual([100, 100, 100]);
    expect(of([10, 130, 250], ADOBE(0))).toEqual([10, 130, 250]);
    expect(of([10, 130, 250], [], [...Buffer.from('RGB')])).toEqual([10, 130, 250]);
    expect(of([100, 128, 128], ADOBE(1), [...Buffer.from('RGB')])).toEqual([100, 100, 100]);
    // Inks are inverted: 255 is none.
    expect(of([255, 51, 0, 255], ADOBE(0))).toEqual([255, 51, 0]);
    expect(of([255, 51, 0, 102], ADOBE(0))).toEqual([102, 20, 0]);
    expect(of([55, 128, 128, 102], ADOBE(2))).toEqual([80, 80, 80]);
  });

  it.each(['squares', 'squares-progressive', 'squares-grey'])('is to a step what jpeg-js reads: %s', (name) => {
    const bytes = new Uint8Array(readFileSync(new URL(`../testdata/${name}.jpg`, import.meta.url)));
    expect(greatestDifference(read(bytes).data, decode(bytes, { useTArray: true }).data)).toBeLessThanOrEqual(1);
  });

  it('is that also where every coefficient has a value', () => {
    const data = Uint8Array.from({ length: 4 * 53 * 29 }, (_, i) => (Math.imul(i, 2654435761) >>> 13) & 255);
    for (const quality of [5, 50, 100]) {
      const bytes = new Uint8Array(encode({ width: 53, height: 29, data }, quality).data);
      expect(greatestDifference(read(bytes).data, decode(bytes, { useTArray: true }).data)).toBeLessThanOrEqual(1);
    }
  });
});

const greatestDifference = (a: ArrayLike<number>, b: ArrayLike<number>): number => {
  expect(a.length).toBe(b.length);
  let most = 0;
  for (let i = 0; i < a.length; i++) most = Math.max(most, Math.abs(a[i] - b[i]));
  return most;
};

describe('a JPEG that cannot be read', () => {
  const whole = jpegOf({ width: 64, height: 64, components: [{ value: (x, y) => (x * 31 + y * 77) % 256 }] });
  const start = whole.indexOf(0xda);
  const frame = whole.indexOf(0xc0);
  const changed = (at: number, ...bytes: readonly number[]): Uint8Array => {
    const copy = whole.slice();
    copy.set(bytes, at);
    return copy;
  };
  const said = (bytes: Uint8Array): string => {
    try {
      read(bytes);
    } catch (thrown) {
      if (thrown instanceof MessageError) return inEnglish(thrown.text);
      throw thrown;
    }
    return 'read';
  };

  it('says why', () => {
    expect(said(whole)).toBe('read');
    const early = 'its codes end too early or are in none of its tables';
    expect(said(Uint8Array.from([...whole.subarray(0, start + 20), 0xff, 0xd9]))).toBe(early);
    expect(said(changed(start + 10, 0xff, 0xd9))).toBe(early);
    expect(said(changed(frame + 3, 12))).toBe('it has 12 bits a channel; 8 are read');
    expect(said(changed(frame + 8, 2))).not.toBe('read');
    expect(said(changed(frame, 0xc9))).toMatch(/^it is compressed in a way that is not read/);
    expect(said(changed(frame, 0xe5))).toBe('no frame header');
    expect(said(Uint8Array.from([...whole.subarray(0, start - 1), ...whole.subarray(frame - 1)]))).toBe(
      'it has two frame headers',
    );
  });

  it('has more scans than a picture needs', () => {
    const scan = whole.subarray(start - 1, whole.length - 2);
    const bytes = Uint8Array.from([
      ...whole.subarray(0, start - 1),
      ...Array(300)
        .fill([...scan])
        .flat(),
      0xff,
      0xd9,
    ]);
    expect(said(bytes)).toBe('it has more than 256 scans');
  });

  it('is asked for its size before memory is taken', () => {
    const sizes: number[][] = [];
    decodeJpeg(whole, (...size) => void sizes.push(size));
    expect(sizes).toEqual([[64, 64]]);
  });
});
