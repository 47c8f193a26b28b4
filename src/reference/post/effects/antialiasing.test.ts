import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../../math/quat.ts';
import { perspective } from '../../../scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type ViewPoint } from '../../../scene/view/view.ts';
import { applyEffect } from './applyEffect.ts';
import { FloatImage } from './effectInput.ts';

const VIEW: ViewPoint = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, lens: perspective(1) };
const smoothed = (image: FloatImage, args: readonly number[] = []): FloatImage =>
  applyEffect('antialiasing', args, {
    image,
    aovs: new Map(),
    view: VIEW,
    settings: DEFAULT_SETTINGS,
    zenith: [0, 1, 0],
  });
const sum = ({ values }: FloatImage): number => values.reduce((a, b) => a + b, 0);

type Point = readonly [number, number];
/** Positive on one side of a line. */
type Line = (x: number, y: number) => number;
const lineAt = (degrees: number, x0: number, y0: number): Line => {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return (x, y) => (y - y0) * c - (x - x0) * s;
};

/** Area of a pixel on the positive side: the square, clipped by the line. */
function coverage(line: Line, x: number, y: number): number {
  const square: readonly Point[] = [
    [x, y],
    [x + 1, y],
    [x + 1, y + 1],
    [x, y + 1],
  ];
  const kept = square.flatMap((a, i): readonly Point[] => {
    const b = square[(i + 1) % 4]!;
    const [p, q] = [line(...a), line(...b)];
    const t = p / (p - q);
    const cut: Point = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    return [...(p > 0 ? [a] : []), ...(p > 0 !== q > 0 ? [cut] : [])];
  });
  return Math.abs(
    kept.reduce((area, a, i) => {
      const b = kept[(i + 1) % kept.length]!;
      return area + (a[0] * b[1] - b[0] * a[1]) / 2;
    }, 0),
  );
}

const SIZE = 64;
/** A picture of a line's sides with one sample per pixel. */
const gray = (of: (x: number, y: number) => number, [dark, light]: Point = [0, 1]): FloatImage =>
  FloatImage.of(SIZE, SIZE, 3, (x, y) => [0, 0, 0].map(() => dark + (light - dark) * of(x, y)));
const hard = (line: Line, levels?: Point) => gray((x, y) => Number(line(x + 0.5, y + 0.5) > 0), levels);

/** Away from the picture's borders, where the continuation of an edge is unknown. */
function error(image: FloatImage, line: Line): number {
  let squares = 0;
  for (let y = 20; y < SIZE - 20; y++)
    for (let x = 20; x < SIZE - 20; x++) squares += (image.at(x, y)[0]! - coverage(line, x, y)) ** 2;
  return Math.sqrt(squares);
}

const AROUND = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;
/** A line at any angle, near the middle. */
const someLine = fc
  .tuple(fc.integer({ min: 0, max: 359 }), fc.double({ min: -1, max: 1, noNaN: true }))
  .map(([degrees, offset]) => lineAt(degrees, SIZE / 2 + offset, SIZE / 2 - offset / 3));
const noise = (from: number, to: number) =>
  fc
    .array(fc.double({ min: from, max: to, noNaN: true }), { minLength: 3 * 12 * 9, maxLength: 3 * 12 * 9 })
    .map((values) => new FloatImage(12, 9, 3, values));
const mirrorImage = (image: FloatImage): FloatImage => image.map((x, y) => image.at(image.width - 1 - x, y));
const transposed = (image: FloatImage): FloatImage =>
  FloatImage.of(image.height, image.width, 3, (x, y) => image.at(y, x));
function expectClose(a: FloatImage, b: FloatImage): void {
  const errors = a.values.map((value, i) => Math.abs(value - b.values[i]!) / (1 + Math.abs(value)));
  expect(Math.max(...errors)).toBeLessThan(1e-12);
}

describe('on slanted edges', () => {
  it('antialiasing leaves a third of the error, and much less on edges nearly along rows or columns', () => {
    const left = (degrees: number, offset: number): number => {
      const line = lineAt(degrees, 31.7 + offset, 32.2 - offset);
      return error(smoothed(hard(line)), line) / error(hard(line), line);
    };
    const ratios = Array.from({ length: 14 }, (_, i) => left(12.8 * i + 3, 0.13 * i));
    expect(ratios.reduce((a, b) => a + b) / ratios.length).toBeLessThan(0.4);
    expect(Math.max(...ratios)).toBeLessThan(0.75);
    for (const degrees of [8, 83, 94]) expect(left(degrees, 0)).toBeLessThan(0.3);
  });

  it('long steps need a longer search', () => {
    const line = lineAt(2.5, 32, 32);
    const missed = (search: number) => error(smoothed(hard(line), [0.1, search]), line);
    expect(missed(32)).toBeLessThan(0.3 * missed(4));
  });

  it('covers the same area at any brightness', () => {
    fc.assert(
      fc.property(
        someLine,
        fc.constantFrom<Point>([0.02, 40], [900, 2000], [3, 0.5], [0, 0.03]),
        (line, [from, to]) => {
          const shares = smoothed(hard(line));
          const expected = shares.map((x, y) => shares.at(x, y).map((share) => from + (to - from) * share));
          expectClose(smoothed(hard(line, [from, to])), expected);
        },
      ),
      { numRuns: 5 },
    );
  });

  it('conserves light within one percent, also of round shapes', () => {
    fc.assert(
      fc.property(someLine, (line) => {
        expect(Math.abs(sum(smoothed(hard(line))) / sum(hard(line)) - 1)).toBeLessThan(0.01);
      }),
      { numRuns: 5 },
    );
    const disc = gray((x, y) => Number(Math.hypot(x - 30.2, y - 32.7) < 17.4));
    expect(Math.abs(sum(smoothed(disc)) / sum(disc) - 1)).toBeLessThan(0.01);
  });

  it('detects edges between colours of equal luminance', () => {
    const hues = (line: Line) =>
      hard(line).map((x, y) => (line(x + 0.5, y + 0.5) > 0 ? [0.7152, 0, 0] : [0, 0.2126, 0]));
    const line = lineAt(20, 32, 32);
    const shares = smoothed(hard(line));
    expectClose(
      smoothed(hues(line)),
      shares.map((x, y) => [0.7152 * shares.at(x, y)[0]!, 0.2126 * (1 - shares.at(x, y)[0]!), 0]),
    );
  });
});

describe('antialiasing changes no bit', () => {
  it('of pictures without edges', () => {
    fc.assert(
      fc.property(noise(10, 12), (image) => {
        expect(smoothed(image, [0.1, 16, 1]).values).toEqual(image.values);
      }),
      { numRuns: 20 },
    );
  });

  it('of edges along rows and columns', () => {
    for (const image of [gray((x) => Number(x < 20)), gray((_, y) => Number(y % 16 < 3), [0.1, 7])])
      expect(smoothed(image, [0.1, 16, 1]).values).toEqual(image.values);
  });

  it('where the threshold is not exceeded: √(0.5/0.7) is 0.15 less than 1', () => {
    const image = hard(lineAt(20, 32, 32), [0.5, 0.7]);
    expect(smoothed(image, [0.16]).values).toEqual(image.values);
    expect(smoothed(image, [0.15]).values).not.toEqual(image.values);
  });
});

describe('antialiasing', () => {
  it('is symmetric', () => {
    fc.assert(
      fc.property(noise(0, 9), fc.double({ min: 0, max: 1, noNaN: true }), (image, single) => {
        const args = [0.1, 5, single];
        expectClose(smoothed(mirrorImage(image), args), mirrorImage(smoothed(image, args)));
        expectClose(smoothed(transposed(image), args), transposed(smoothed(image, args)));
      }),
      { numRuns: 20 },
    );
    const line = lineAt(17, 30.3, 33);
    expectClose(smoothed(mirrorImage(hard(line))), mirrorImage(smoothed(hard(line))));
    expectClose(smoothed(transposed(hard(line))), transposed(smoothed(hard(line))));
  });

  it('stays within the range of the neighbourhood', () => {
    fc.assert(
      fc.property(noise(0, 100), (image) => {
        const after = smoothed(image, [0.05, 8, 0.7]);
        const excess = after.values.map((value, i) => {
          const [x, y] = [Math.floor(i / 3) % 12, Math.floor(i / 36)];
          const cross = [...AROUND, [0, 0] as const].map(([dx, dy]) => image.at(x + dx, y + dy)[i % 3]!);
          return Math.max(Math.min(...cross) - value, value - Math.max(...cross));
        });
        expect(Math.max(...excess)).toBeLessThan(1e-9);
      }),
      { numRuns: 20 },
    );
  });

  it('spreads single pixels without loss: ⅛ over each side', () => {
    const speck = gray((x, y) => Number(x === 30 && y === 31));
    const spread = smoothed(speck, [0.1, 16, 1]);
    expect(spread.at(30, 31)[0]).toBe(0.5);
    for (const [dx, dy] of AROUND) expect(spread.at(30 + dx, 31 + dy)[0]).toBe(1 / 8);
    expect(sum(spread)).toBe(3);
    const board = gray((x, y) => (x + y) % 2);
    expect(smoothed(board, [0.1, 16, 1]).at(20, 21)).toEqual([0.5, 0.5, 0.5]);
  });

  it('changes smooth edges on average by less than half the error of hard ones', () => {
    const angles = [5, 10, 30, 45, 70, 130, 175];
    const parts = angles.map((degrees) => {
      const line = lineAt(degrees, 32.2, 31.9);
      return error(smoothed(gray((x, y) => coverage(line, x, y))), line) / error(hard(line), line);
    });
    expect(parts.reduce((a, b) => a + b) / parts.length).toBeLessThan(0.5);
  });
});
