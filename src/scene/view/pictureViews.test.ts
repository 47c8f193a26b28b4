import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { ZERO } from '../../math/vec3.ts';
import { perspective } from './lenses/perspectiveLens.ts';
import { METER_CELLS, mergeReadings } from './metering.ts';
import {
  assertViewports,
  composeViews,
  type PictureView,
  type PictureViews,
  type PixelRect,
  scaleViewports,
  viewPixelAt,
} from './pictureViews.ts';

const SIZE = { width: 10, height: 6 };
const view = (viewport?: PixelRect): PictureView => ({
  t: 0,
  position: ZERO,
  u: ZERO,
  orientation: IDENTITY,
  lens: perspective(1),
  ...(viewport && { viewport }),
});
const rect = (x: number, y: number, width: number, height: number): PixelRect => ({ x, y, width, height });
const PAIR: PictureViews = [view(rect(0, 1, 4, 5)), view(rect(6, 0, 4, 6))];

describe('viewports', () => {
  it('may leave pixels uncovered, and touch', () => {
    expect(() => assertViewports(PAIR, SIZE)).not.toThrow();
    expect(() => assertViewports([view()], SIZE)).not.toThrow();
    expect(() => assertViewports([view(rect(0, 0, 5, 6)), view(rect(5, 0, 5, 6))], SIZE)).not.toThrow();
  });

  it.each([
    ['leaves the picture of 10 × 6', rect(7, 0, 4, 6)],
    ['leaves the picture of 10 × 6', rect(-1, 0, 4, 6)],
    ['whole pixels', rect(0.5, 0, 4, 6)],
    ['whole pixels', rect(0, 0, Number.NaN, 6)],
    ['is empty', rect(0, 0, 0, 6)],
    ['overlaps that of view 1', rect(3, 5, 2, 1)],
  ])('%s: refused', (reason, wrong) => {
    expect(() => assertViewports([PAIR[0], view(wrong)], SIZE)).toThrow(reason);
  });

  it('that are absent cover the picture, and so overlap any other', () => {
    expect(() => assertViewports([view(), PAIR[0]], SIZE)).toThrow('overlaps');
  });

  it('tell which view covers a point, and where it is there', () => {
    expect(viewPixelAt(PAIR, SIZE, 6.5, 2.5)).toMatchObject({ index: 1, x: 0.5, y: 2.5, width: 4, height: 6 });
    expect(viewPixelAt(PAIR, SIZE, 1, 0.9)).toBeUndefined();
    expect(viewPixelAt(PAIR, SIZE, 4, 3)).toBeUndefined();
    expect(viewPixelAt([view()], SIZE, 9, 5)).toMatchObject({ index: 0, x: 9, y: 5, width: 10, height: 6 });
    expect(viewPixelAt(scaleViewports(PAIR, 0.5), { width: 5, height: 3 }, 3.25, 1.25)).toMatchObject({
      index: 1,
      x: 0.25,
      width: 2,
    });
  });
});

it('pixels of views land where the views are', () => {
  const parts = PAIR.map(({ viewport }, i) => ({
    rect: viewport!,
    values: Float32Array.from({ length: 2 * viewport!.width * viewport!.height }, (_, k) => 1000 * (i + 1) + k),
  }));
  const whole = composeViews(parts, SIZE, 2, new Float32Array(2 * SIZE.width * SIZE.height));
  for (let y = 0; y < SIZE.height; y++)
    for (let x = 0; x < SIZE.width; x++) {
      const found = viewPixelAt(PAIR, SIZE, x, y);
      const first = found ? 1000 * (found.index + 1) + 2 * (found.y * found.width + found.x) : 0;
      expect([...whole.subarray(2 * (y * SIZE.width + x)).subarray(0, 2)]).toEqual(found ? [first, first + 1] : [0, 0]);
    }
});

describe('readings of the light meter', () => {
  const cells = (value: (x: number, y: number) => number): Float32Array =>
    Float32Array.from({ length: METER_CELLS ** 2 }, (_, i) => value(i % METER_CELLS, Math.floor(i / METER_CELLS)));
  const readings = (value: (x: number, y: number) => number) => ({
    luminance: cells(value),
    doppler: cells(value),
    time: cells(value),
  });

  it('of one view that fills the picture are its own', () => {
    const own = readings((x, y) => x + 100 * y);
    expect(mergeReadings([{ rect: rect(0, 0, 10, 6), readings: own }], SIZE)).toBe(own);
  });

  it('of several are those of the view at each place, and no number where there is none', () => {
    // 32 cells of the picture are 64 of each half.
    const size = { width: 256, height: 128 };
    const left = { rect: rect(0, 0, 128, 128), readings: readings((x) => x) };
    const right = { rect: rect(128, 0, 128, 64), readings: readings((x, y) => 1000 + y + 0 * x) };
    const { luminance } = mergeReadings([left, right], size);
    const at = (x: number, y: number) => luminance[METER_CELLS * y + x];
    expect([at(0, 0), at(1, 5), at(31, 63)]).toEqual([1, 3, 63]);
    expect([at(32, 0), at(40, 31)]).toEqual([1001, 1063]);
    expect(at(40, 32)).toBeNaN();
  });
});
