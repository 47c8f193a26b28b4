import fc from 'fast-check';
import { expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { add, dot, length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { aberrate } from '../../physics/optics/aberration.ts';
import { aberrateCone, coneAround, coneMayIntersectFrustum, frustumSides } from './culling.ts';

const unit = fc
  .tuple(fc.double({ min: -1, max: 1, noNaN: true }), fc.double({ min: 0, max: 2 * Math.PI, noNaN: true }))
  .map(([z, a]): Vec3 => [Math.sqrt(1 - z * z) * Math.cos(a), Math.sqrt(1 - z * z) * Math.sin(a), z]);
const fraction = fc.double({ min: 0, max: 1, noNaN: true });
const speed = fc.double({ min: 0, max: 50, noNaN: true });

it('what lies in a cone of directions lies in the aberrated cone', () => {
  fc.assert(
    fc.property(
      unit,
      unit,
      unit,
      fraction,
      fraction,
      speed,
      (axis, inside, velocityDirection, size, within, speedOfObserver) => {
        const sphere = { center: scale(axis, 10), radius: 9.9 * size };
        const cone = coneAround(sphere)!;
        const u = scale(velocityDirection, speedOfObserver);
        const n = normalize(add(sphere.center, scale(inside, sphere.radius * within)));
        const aberrated = aberrateCone(cone, u);
        expect(length(aberrated.axis)).toBeCloseTo(1, 9);
        expect(dot(aberrated.axis, aberrate(n, u))).toBeGreaterThanOrEqual(aberrated.cosine - 1e-6);
      },
    ),
  );
});

it('the rim of a cone stays the rim: a circle on the sky stays one', () => {
  const cone = coneAround({ center: [0, 0, -10], radius: 6 })!;
  const u: Vec3 = [0.7, -0.3, 1.1];
  const aberrated = aberrateCone(cone, u);
  for (let a = 0; a < 6; a++) {
    const rim: Vec3 = [0.6 * Math.cos(a), 0.6 * Math.sin(a), -0.8];
    expect(dot(aberrated.axis, aberrate(rim, u))).toBeCloseTo(aberrated.cosine, 12);
  }
});

it('there is no cone for an observer inside the sphere, who sees it in all directions', () => {
  expect(coneAround({ center: [0, 0, 1], radius: 2 })).toBeUndefined();
  expect(coneAround({ center: [0, 0, 1], radius: Number.POSITIVE_INFINITY })).toBeUndefined();
});

it('a cone is kept wherever one of its directions is inside the picture', () => {
  const sides = frustumSides(IDENTITY, { tanX: 1, tanY: 0.5, aspect: 2, center: [0, 0] });
  const inPicture = ([x, y, z]: Vec3) => z < 0 && Math.abs(x) <= -z && Math.abs(y) <= -z / 2;
  fc.assert(
    fc.property(unit, unit, fraction, fraction, (axis, inside, size, within) => {
      const sphere = { center: scale(axis, 10), radius: 9.9 * size };
      const n = add(sphere.center, scale(inside, sphere.radius * within));
      if (inPicture(n)) expect(coneMayIntersectFrustum(coneAround(sphere)!, sides)).toBe(true);
    }),
    { numRuns: 500 },
  );
  expect(coneMayIntersectFrustum({ axis: [0, 0, 1], cosine: 0.9 }, sides)).toBe(false);
  expect(coneMayIntersectFrustum({ axis: normalize([3, 0, -1]), cosine: 0.99 }, sides)).toBe(false);
});
