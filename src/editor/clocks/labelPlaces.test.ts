import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { labelPlaces, type PointLabel } from './labelPlaces.ts';

const frame = { width: 400, height: 300 };
const label = { width: 80, height: 20 };
const labelled = (points: readonly Pick<PointLabel, 'x' | 'y' | 'last'>[]): readonly PointLabel[] =>
  points.map((point) => ({ ...point, ...label }));
/** As they are in the next frame. */
const again = (labels: readonly PointLabel[]): readonly PointLabel[] => {
  const places = labelPlaces(labels, frame);
  return labels.map((each, i) => {
    const place = places[i];
    return { ...each, last: place && ([place[0] - each.x, place[1] - each.y] as const) };
  });
};

const point = fc.record({ x: fc.integer({ min: 0, max: 400 }), y: fc.integer({ min: 0, max: 300 }) });
const points = (most: number) => fc.array(point, { maxLength: most });
/** With places before, at will. */
const moving = fc.array(
  fc.record({
    x: fc.integer({ min: 0, max: 400 }),
    y: fc.integer({ min: 0, max: 300 }),
    last: fc.option(fc.tuple(fc.integer({ min: -90, max: 90 }), fc.integer({ min: -200, max: 200 })), {
      nil: undefined,
    }),
  }),
  { maxLength: 20 },
);

describe('labels beside points', () => {
  it('are to the right, or to the left where there is no room', () => {
    const [right, left] = labelPlaces(
      labelled([
        { x: 100, y: 50 },
        { x: 390, y: 250 },
      ]),
      frame,
    );
    expect(right).toEqual([110, 40]);
    expect(left).toEqual([300, 240]);
  });

  it('lie in the frame and cover neither each other nor a point, if they are shown', () =>
    fc.assert(
      fc.property(moving, (some) => {
        const places = labelPlaces(labelled(some), frame).filter((place) => place !== undefined);
        places.forEach(([left, top], i) => {
          expect(left).toBeGreaterThanOrEqual(0);
          expect(left + label.width).toBeLessThanOrEqual(frame.width);
          expect(top).toBeGreaterThanOrEqual(0);
          expect(top + label.height).toBeLessThanOrEqual(frame.height);
          for (const [otherLeft, otherTop] of places.slice(0, i))
            expect(Math.abs(left - otherLeft) < label.width && Math.abs(top - otherTop) < label.height).toBe(false);
          for (const { x, y } of some)
            expect(x > left && x < left + label.width && y > top && y < top + label.height).toBe(false);
        });
      }),
    ));

  it('are all there while there is room', () =>
    fc.assert(
      // Three other labels take 20 px of the height, four points 12, and each another 20 px above it: 248 of 280.
      fc.property(points(4), (some) => {
        expect(labelPlaces(labelled(some), frame)).not.toContain(undefined);
      }),
    ));

  it('stay where they are while nothing moves', () =>
    fc.assert(
      fc.property(moving, (some) => {
        const next = again(labelled(some));
        expect(again(next)).toEqual(next);
      }),
    ));

  it('keep their order while points tremble, and return when there is room', () => {
    const pair = (y: number, last?: PointLabel['last']) =>
      labelled([
        { x: 100, y: 100 },
        { x: 100, y, last },
      ]);
    const [, above] = again(pair(99));
    expect(above!.last).toEqual([10, 70 - 99 + 0]);
    const [, still] = again(pair(101, above!.last));
    expect(still!.last).toEqual([10, 70 - 101]);
    expect(again(pair(101))[1]!.last).toEqual([10, 110 - 101]);
    expect(again(pair(112, still!.last))[1]!.last).toEqual([10, 110 - 112]);
    expect(again(pair(140, still!.last))[1]!.last).toEqual([10, -10]);
  });
});
