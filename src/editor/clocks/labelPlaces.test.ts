import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { labelPlaces } from './labelPlaces.ts';

const frame = { width: 400, height: 300 };
const label = { width: 80, height: 20 };

describe('labels beside points', () => {
  it('are to the right, or to the left where there is no room', () => {
    const [right, left] = labelPlaces(
      [
        { x: 100, y: 50, ...label },
        { x: 390, y: 250, ...label },
      ],
      frame,
    );
    expect(right).toEqual([110, 40]);
    expect(left).toEqual([300, 240]);
  });

  it('lie in the frame, and not on each other while there is room', () =>
    fc.assert(
      fc.property(
        // Seven labels of 20 px, each with less than another 20 px lost above it, fit below each other.
        fc.array(fc.record({ x: fc.integer({ min: 0, max: 400 }), y: fc.integer({ min: 0, max: 300 }) }), {
          maxLength: 7,
        }),
        (points) => {
          const places = labelPlaces(
            points.map((point) => ({ ...point, ...label })),
            frame,
          );
          places.forEach(([left, top], i) => {
            expect(left).toBeGreaterThanOrEqual(0);
            expect(left + label.width).toBeLessThanOrEqual(frame.width);
            expect(top).toBeGreaterThanOrEqual(0);
            expect(top + label.height).toBeLessThanOrEqual(frame.height);
            for (const [otherLeft, otherTop] of places.slice(0, i))
              expect(Math.abs(left - otherLeft) < label.width && Math.abs(top - otherTop) < label.height).toBe(false);
          });
        },
      ),
    ));
});
