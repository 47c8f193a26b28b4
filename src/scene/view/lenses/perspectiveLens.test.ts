import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { farthestCorner, frustumOf, offAxisLens, perspective, pixelsPerTangent } from './perspectiveLens.ts';

const tangent = fc.double({ min: -5, max: 5, noNaN: true });
const extent = fc.double({ min: 1e-3, max: 5, noNaN: true });

describe('a perspective lens', () => {
  it('has square pixels unless its aspect is given', () => {
    const { tanX, tanY, center } = frustumOf(perspective(Math.PI / 2), 300, 200);
    expect([tanX, tanY]).toEqual([expect.closeTo(1.5, 15), expect.closeTo(1, 15)]);
    expect(center).toEqual([0, 0]);
    expect(pixelsPerTangent(frustumOf(perspective(Math.PI / 2), 300, 200), 300, 200)).toBeCloseTo(100, 12);
  });

  it('with sides of its own has these sides, whatever the pixels are', () => {
    fc.assert(
      fc.property(tangent, extent, tangent, extent, (left, width, bottom, height) => {
        const [right, top] = [left + width, bottom + height];
        const lens = offAxisLens({ left, right, bottom, top });
        const { tanX, tanY, center } = frustumOf(lens, 640, 480);
        expect(center[0] - tanX).toBeCloseTo(left, 10);
        expect(center[0] + tanX).toBeCloseTo(right, 10);
        expect(center[1] - tanY).toBeCloseTo(bottom, 10);
        expect(center[1] + tanY).toBeCloseTo(top, 10);
      }),
    );
  });

  it('counts the pixels of the side that has more of them where they are not square', () => {
    const frustum = frustumOf(offAxisLens({ left: -1, right: 1, bottom: -1, top: 1 }), 400, 100);
    expect(pixelsPerTangent(frustum, 400, 100)).toBeCloseTo(200, 10);
    expect(pixelsPerTangent(frustum, 100, 400)).toBeCloseTo(200, 10);
  });

  it('has its farthest corner where the larger sides meet', () => {
    const frustum = frustumOf(offAxisLens({ left: -1, right: 3, bottom: -2, top: 0.5 }), 10, 10);
    expect(farthestCorner(frustum)).toEqual([expect.closeTo(3, 12), expect.closeTo(2, 12)]);
  });

  it.each([
    { left: 1, right: 1, bottom: -1, top: 1 },
    { left: -1, right: 1, bottom: 1, top: -1 },
    { left: Number.NaN, right: 1, bottom: -1, top: 1 },
    { left: Number.NEGATIVE_INFINITY, right: 1, bottom: -1, top: 1 },
  ])('rejects empty frustums: $left $right $bottom $top', (sides) => {
    expect(() => offAxisLens(sides)).toThrow(RangeError);
  });
});
