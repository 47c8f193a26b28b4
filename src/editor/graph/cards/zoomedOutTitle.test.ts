import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { CanvasRect } from './cardGeometry.ts';
import { canvasPixelSize, LINE_HEIGHT, layoutTitle, titleOverhangs } from './zoomedOutTitle.ts';

describe('the size of a screen pixel', () => {
  it('is never underestimated, and hardly overestimated', () => {
    fc.assert(
      fc.property(fc.double({ min: 0.03, max: 0.599, noNaN: true }), (zoom) => {
        const pixel = canvasPixelSize(zoom)!;
        expect(pixel * zoom).toBeGreaterThanOrEqual(1 - 1e-12);
        expect(pixel * zoom).toBeLessThan(1.27);
      }),
    );
    expect(canvasPixelSize(0.6)).toBeUndefined();
  });

  it('is constant over small changes of zoom', () => {
    const pixels = Array.from({ length: 1000 }, (_, i) => canvasPixelSize(0.15 + (0.15 * i) / 1000));
    expect(new Set(pixels).size).toBeLessThanOrEqual(4);
  });
});

describe('the space for titles', () => {
  const ROW: CanvasRect[] = [
    { at: [0, 0], size: [200, 90] },
    { at: [260, 0], size: [200, 90] },
    { at: [0, 150], size: [200, 90] },
    { at: [1000, 0], size: [200, 90] },
  ];
  const reachesOf = (boxes: readonly CanvasRect[]) => [
    ...titleOverhangs(new Map(boxes.map((box, i) => [`${i}`, box]))),
  ];

  it('reaches halfway to neighbours beside and below, and is bounded in empty space', () => {
    expect(Object.fromEntries(reachesOf(ROW))).toEqual({ 0: [30, 30], 1: [30, 30], 2: [100, 30], 3: [100, 60] });
  });

  it('does not overlap that of other nodes, unless the nodes overlap', () => {
    const box = fc.record({
      at: fc.tuple(fc.integer({ min: -1500, max: 1500 }), fc.integer({ min: -900, max: 900 })),
      size: fc.tuple(fc.constant(200), fc.integer({ min: 20, max: 400 })),
    });
    const apart = (a: CanvasRect, b: CanvasRect): boolean =>
      [0, 1].some((i) => a.at[i]! + a.size[i]! <= b.at[i]! || b.at[i]! + b.size[i]! <= a.at[i]!);
    fc.assert(
      fc.property(fc.array(box, { maxLength: 25 }), (boxes) => {
        const found = new Map(reachesOf(boxes));
        const wider = boxes.map(({ at, size }, i): CanvasRect => {
          const [x, y] = found.get(`${i}`)!;
          return { at: [at[0] - x, at[1] - y], size: [size[0] + 2 * x, size[1] + 2 * y] };
        });
        for (const [i, a] of boxes.entries())
          for (const [j, b] of boxes.entries())
            if (i < j && apart(a, b)) expect(apart(wider[i]!, wider[j]!)).toBe(true);
      }),
    );
  });
});

describe('a zoomed-out title', () => {
  const CARD = [200, 96] as const;

  it('has its preferred size if there is room, and is smaller otherwise', () => {
    expect(layoutTitle('Box', CARD, [30, 30], 2)).toEqual({ text: 'Box', size: 26, lines: 1, reach: [0, 0] });
    expect(layoutTitle('Relativity console', CARD, [30, 30], 2)).toMatchObject({ size: 26, lines: 2, reach: [0, 0] });
    const small = layoutTitle('Relativity console', CARD, [30, 30], 4)!;
    expect(small.size).toBeGreaterThanOrEqual(7.5 * 4);
    expect(small.size).toBeLessThan(13 * 4);
  });

  it('extends beyond its node before it is truncated', () => {
    expect(layoutTitle('Transform', CARD, [30, 30], 5)).toMatchObject({ text: 'Transform', lines: 1, reach: [30, 30] });
    const cut = layoutTitle('A title of very many words that nobody can read from there', CARD, [30, 30], 5)!;
    expect(cut.size).toBe(7.5 * 5);
    expect(cut.lines * LINE_HEIGHT * cut.size).toBeLessThanOrEqual(96 + 60);
  });

  it('wraps its words evenly over lines', () => {
    expect(layoutTitle('Transform', CARD, [30, 30], 8)).toMatchObject({ text: 'Trans\u00adform', lines: 2 });
    expect(layoutTitle('Transform', CARD, [30, 0], 8)).toMatchObject({ text: 'Transform', lines: 1 });
  });

  it('is omitted where it would be illegible', () => {
    expect(layoutTitle('Transform', CARD, [0, 0], 16)).toBeUndefined();
  });

  it('wraps between any characters in Chinese, and between words otherwise', () => {
    expect(layoutTitle('相对论控制台', [100, 200], [0, 0], 3)).toMatchObject({ size: 39, lines: 3, reach: [0, 0] });
    expect(layoutTitle('Relativity', [100, 200], [0, 0], 2.4)!.size).toBeLessThan(24);
  });
});
