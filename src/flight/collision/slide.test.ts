import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AT_REST } from '../../../tests/support/flightFixtures.ts';
import { direction, expectClose, properVelocityUpTo } from '../../../tests/support/physicsArbitraries.ts';
import { addScaled, cross, dot, length, negate, scale, type Vec3 } from '../../math/vec3.ts';
import { gamma, velocity } from '../../physics/lorentz/boost.ts';
import { addVelocities, relativeVelocity } from '../../physics/lorentz/velocity.ts';
import { boostOf, compose, properVelocityOf } from '../boost.ts';
import { accelerateFlight, flightOf } from '../flightState.ts';
import type { Wall } from './obstacles.ts';
import { alongWall, slideAlong } from './slide.ts';

const wallOf = (normal: Vec3, u: Vec3 = [0, 0, 0]): Wall => ({
  event: { t: 0, x: [0, 0, 0] },
  velocity: boostOf(u),
  normal,
});

describe('sliding along a wall', () => {
  it('at rest keeps the speed along it: 0.6 c at 45° goes on with 0.6 c/√2', () => {
    const slid = slideAlong(boostOf(scale([1, -1, 0], 0.75 / Math.SQRT2)), wallOf([0, 1, 0]));
    expectClose(velocity(properVelocityOf(slid)), [0.6 / Math.SQRT2, 0, 0], 1e-15);
  });

  it('takes away the part across it, and nothing else; what moves away stays as it is', () =>
    fc.assert(
      fc.property(properVelocityUpTo(50), direction, (u, n) => {
        const before = velocity(u);
        const slid = slideAlong(boostOf(u), wallOf(n));
        const into = Math.min(0, dot(before, n));
        expectClose(velocity(properVelocityOf(slid)), addScaled(before, n, -into), 1e-12);
      }),
    ));

  it('does the same in every frame: boosts of the whole situation', () =>
    fc.assert(
      fc.property(properVelocityUpTo(5), direction, properVelocityUpTo(5), (own, n, wall) => {
        if (dot(own, n) >= 0) return;
        // At a wall at rest, by the vectors of physics/; then seen from a frame in which the wall moves.
        const u = velocity(own);
        const along = addScaled(u, n, -dot(u, n));
        const expected = addVelocities(wall, scale(along, 1 / Math.sqrt(1 - dot(along, along))));
        const slid = properVelocityOf(slideAlong(boostOf(addVelocities(wall, own)), wallOf(n, wall)));
        expectClose(slid, expected, 1e-10 * gamma(expected));
        expect(Math.abs(dot(relativeVelocity(slid, wall), n))).toBeLessThan(1e-9 * gamma(slid) * gamma(wall));
      }),
    ));
});

it('a push along a wall keeps one in its plane', () =>
  fc.assert(
    fc.property(properVelocityUpTo(5), direction, direction, properVelocityUpTo(5), (wallU, n, side, thrust) => {
      const tangent = cross(n, side);
      const state = {
        ...flightOf(AT_REST),
        velocity: compose(boostOf(wallU), boostOf(tangent)),
      };
      const push = { direction: boostOf(thrust).direction, size: 3 };
      const [arc] = alongWall([{ dTau: 0.5, push }], state.velocity, wallOf(n, wallU));
      const after = arc!.push ? accelerateFlight(state, arc!.push, 0.5, 10) : state;
      const across = dot(relativeVelocity(properVelocityOf(after.velocity), wallU), n);
      const free = dot(relativeVelocity(properVelocityOf(accelerateFlight(state, push, 0.5, 10).velocity), wallU), n);
      // Away from the wall it is free.
      expectClose(across, Math.max(0, free), 1e-9 * (1 + length(tangent)) * gamma(wallU) ** 2);
    }),
  ));

it('a push straight into a wall is none', () => {
  const [arc] = alongWall(
    [{ dTau: 1, push: { direction: [0, -1, 0], size: 5 } }],
    boostOf([3, 0, 0]),
    wallOf([0, 1, 0]),
  );
  expect(arc).toEqual({ dTau: 1 });
  const away = { dTau: 1, push: { direction: negate([0, -1, 0] as Vec3), size: 5 } };
  expect(alongWall([away], boostOf([3, 0, 0]), wallOf([0, 1, 0]))).toEqual([away]);
});
