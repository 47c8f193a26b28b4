import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { CanvasRect } from '../cards/cardGeometry.ts';
import { fitTransform, type ViewportTransform } from './fitView.ts';

const SIZE = [970, 312] as const;
const TOOLS: CanvasRect = { at: [690, 8], size: [272, 32] };
const MINIMAP: CanvasRect = { at: [810, 200], size: [150, 100] };

const shown = ({ at, size }: CanvasRect, { x, y, zoom }: ViewportTransform): CanvasRect => ({
  at: [at[0] * zoom + x, at[1] * zoom + y],
  size: [size[0] * zoom, size[1] * zoom],
});
const apart = (a: CanvasRect, b: CanvasRect): boolean =>
  [0, 1].some((axis) => a.at[axis]! + a.size[axis]! <= b.at[axis]! || b.at[axis]! + b.size[axis]! <= a.at[axis]!);

it('a graph fills the canvas if there are no overlays', () => {
  const view = fitTransform([{ at: [100, -50], size: [2000, 400] }], SIZE, [])!;
  expect(view.zoom).toBeCloseTo((970 - 32) / 2000, 12);
  expect(shown({ at: [100, -50], size: [2000, 400] }, view).at[0]).toBeCloseTo(16, 9);
  expect(fitTransform([{ at: [0, 0], size: [200, 100] }], SIZE, [])!.zoom).toBe(1.1);
  expect(fitTransform([], SIZE, [])).toBeUndefined();
});

it('the ends of a chain are beside or below the tools, not covered by them', () => {
  const zoomOf = (length: number): number => {
    const chain = Array.from({ length }, (_, i): CanvasRect => ({ at: [260 * i, 0], size: [200, 230] }));
    const blocks = Array.from({ length: 8 }, (_, i): CanvasRect => ({ at: [0, 300 * (i + 1)], size: [200, 100] }));
    const view = fitTransform([...chain, ...blocks], SIZE, [TOOLS, MINIMAP])!;
    for (const box of [...chain, ...blocks]) expect(apart(shown(box, view), TOOLS)).toBe(true);
    return view.zoom;
  };
  // The short graph needs no margin at the top; neither needs one for the minimap, whose corner they leave free.
  expect(zoomOf(20)).toBeCloseTo((312 - 32) / 2500, 12);
  expect(zoomOf(34)).toBeCloseTo((312 - 40 - 32) / 2500, 12);
});

it('no node is covered by overlays, and all are visible, if there is room', () => {
  const box = fc.record({
    at: fc.tuple(fc.integer({ min: -5000, max: 5000 }), fc.integer({ min: -3000, max: 3000 })),
    size: fc.tuple(fc.integer({ min: 20, max: 300 }), fc.integer({ min: 20, max: 400 })),
  });
  fc.assert(
    fc.property(fc.array(box, { minLength: 1, maxLength: 30 }), (boxes) => {
      const view = fitTransform(boxes, SIZE, [TOOLS, MINIMAP])!;
      for (const each of boxes) {
        const { at, size } = shown(each, view);
        expect(apart({ at, size }, TOOLS) && apart({ at, size }, MINIMAP)).toBe(true);
        expect(at[0]).toBeGreaterThan(0);
        expect(at[0] + size[0]).toBeLessThan(SIZE[0]);
        expect(at[1]).toBeGreaterThan(0);
        expect(at[1] + size[1]).toBeLessThan(SIZE[1]);
      }
    }),
  );
});

it('overlays do not shrink a graph by half', () => {
  const boxes: CanvasRect[] = [{ at: [0, 0], size: [1000, 1000] }];
  const wide: CanvasRect = { at: [0, 60], size: [970, 190] };
  expect(fitTransform(boxes, SIZE, [wide])).toEqual(fitTransform(boxes, SIZE, []));
});
