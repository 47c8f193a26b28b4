import fc from 'fast-check';
import { expect, it } from 'vitest';
import { conjugate, fromAxisAngle, rotate } from '../../math/quat.ts';
import { add, addScaled, cross, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { aberrate, unaberrate } from '../../physics/optics/aberration.ts';
import { parallaxBound, pixelsPerRestRadian } from './captureBounds.ts';
import { lensDirection, lensPixel } from './lenses/lenses.ts';
import { perspective } from './lenses/perspectiveLens.ts';

const coordinate = fc.double({ min: -1, max: 1, noNaN: true });
const vector = fc.tuple(coordinate, coordinate, coordinate) as fc.Arbitrary<Vec3>;
const axis = vector.filter((v) => length(v) > 0.1).map(normalize);
const angleBetween = (a: Vec3, b: Vec3): number => Math.atan2(length(cross(a, b)), dot(a, b));

it('bounds the angle by which any point of a ball is seen elsewhere after a step', () => {
  fc.assert(
    fc.property(axis, fc.double({ min: 1, max: 50, noNaN: true }), vector, axis, (to, distance, step, inBall) => {
      const [center, moved] = [scale(to, distance), scale(step, 0.4 * distance)];
      const radius = 0.2 * distance;
      const point = addScaled(center, inBall, radius);
      const bound = parallaxBound(center, radius, moved);
      expect(angleBetween(point, sub(point, moved))).toBeLessThanOrEqual(bound * (1 + 1e-9) + 1e-12);
    }),
  );
});

it('is |Δp|/R for a far point across the step, and nothing without one', () => {
  expect(parallaxBound([0, 0, -1000], 0, [1, 0, 0])).toBeCloseTo(1e-3, 5);
  expect(parallaxBound([0, 0, -1000], 0, [0, 0, -1])).toBeLessThan(2e-6);
  expect(parallaxBound([0, 0, -1000], 0, [0, 0, 0])).toBe(0);
  expect(parallaxBound([0, 0, -1], 1, [0.1, 0, 0])).toBe(Number.POSITIVE_INFINITY);
});

it('bounds how far a small angle at rest moves anything in the picture, at any velocity', () => {
  const size = { width: 160, height: 90 };
  const lens = perspective(1.2);
  fc.assert(
    fc.property(
      vector,
      axis,
      fc.double({ min: 0, max: Math.PI, noNaN: true }),
      fc.double({ min: 1, max: 159, noNaN: true }),
      fc.double({ min: 1, max: 89, noNaN: true }),
      axis,
      (direction, turnAxis, turn, x, y, aside) => {
        const u = scale(direction, 3);
        const orientation = fromAxisAngle(turnAxis, turn);
        const seen = rotate(orientation, lensDirection(lens, x, y, size)!);
        const atRest = unaberrate(seen, u);
        const moved = normalize(add(atRest, scale(cross(atRest, aside), 1e-6)));
        const angle = angleBetween(atRest, moved);
        fc.pre(angle > 1e-7);
        const back = rotate(conjugate(orientation), aberrate(moved, u));
        const [px, py] = lensPixel(lens, back, size)!;
        const bound = pixelsPerRestRadian({ lens, orientation }, u, size);
        expect(Math.hypot(px - x, py - y)).toBeLessThanOrEqual(bound * angle * 1.001 + 1e-7);
      },
    ),
  );
});
