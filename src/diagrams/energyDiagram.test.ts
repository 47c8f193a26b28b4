import { expect, it } from 'vitest';
import { inEnglish } from '../messages/message.ts';
import { energyDiagram } from './energyDiagram.ts';
import type { Mark, PixelPoint } from './marks.ts';

/** The pixels of β = 0 … 1 and of the values 0 … 4. */
const [LEFT, RIGHT, BOTTOM, TOP] = [58, 976, 1156, 24];
const beta = ([x]: PixelPoint) => (x - LEFT) / (RIGHT - LEFT);
const value = ([, y]: PixelPoint) => ((BOTTOM - y) / (BOTTOM - TOP)) * 4;

const diagram = (u: readonly number[]) =>
  energyDiagram({ bodies: u.map((properSpeed, i) => ({ name: `body ${i}`, properSpeed })), width: 1200, height: 1200 });
const curves = diagram([]).marks.filter(
  (mark): mark is Extract<Mark, { kind: 'lines' }> =>
    mark.kind === 'lines' && typeof mark.role === 'number' && mark.lines[0]!.length > 2,
);

const expected = [
  (b: number) => 1 / Math.sqrt(1 - b * b) - 1,
  (b: number) => (b * b) / 2,
  (b: number) => b / Math.sqrt(1 - b * b),
  (b: number) => b,
];

it('draws γ − 1, β²/2, γβ and β', () => {
  expect(curves).toHaveLength(4);
  for (const [n, curve] of curves.entries()) {
    const points = curve.lines[0]!;
    for (let i = 1; i < points.length; i++) {
      // Ends of chords, and their middles, by the curve's inverse where it is steep.
      const [a, b] = [points[i - 1]!, points[i]!];
      for (const at of [b, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] as const]) {
        const off = value(at) - expected[n]!(beta(at));
        const slope = (expected[n]!(beta(at) + 1e-7) - expected[n]!(beta(at))) / 1e-7;
        const perPixel = 4 / (BOTTOM - TOP);
        const steep = (slope * (BOTTOM - TOP)) / 4 / (RIGHT - LEFT);
        expect(Math.abs(off) / perPixel / Math.hypot(1, steep)).toBeLessThan(0.25);
      }
    }
    expect(beta(points[0]!)).toBeCloseTo(0, 9);
  }
  expect(curves.map(({ lines }) => value(lines[0]!.at(-1)!))).toEqual(
    [4, 0.5, 4, 1].map((end) => expect.closeTo(end, 6)),
  );
});

it('marks bodies on all four curves, as far as these are in the picture', () => {
  const dots = (u: number) =>
    diagram([u]).marks.filter((mark) => mark.kind === 'dot' && mark.role === 2 && mark.title !== undefined);
  const at = dots(4 / 3).map((mark) => (mark as { at: PixelPoint }).at);
  for (const place of at) expect(beta(place)).toBeCloseTo(0.8, 9);
  expect(at.map(value)).toEqual([2 / 3, 0.32, 4 / 3, 0.8].map((v) => expect.closeTo(v, 9)));
  expect(dots(1000)).toHaveLength(2);
});

it('tells speeds near c from c', () => {
  expect(inEnglish(diagram([1000]).description)).toContain('body 0: β = 1 − 5e−7.');
  expect(inEnglish(diagram([1e9]).description)).toContain('body 0: β = 1 − 5e−19.');
  expect(inEnglish(diagram([0.75]).description)).toContain('body 0: β = 0.6.');
});
