import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  direction,
  expectClose,
  magnitude,
  perpendicular,
  properVelocityUpTo,
  uniform,
} from '../../tests/support/physicsArbitraries.ts';
import { conjugate, fromAxisAngle, IDENTITY, multiply, rotate, rotationAngle } from '../math/quat.ts';
import { addScaled, dot, length, negate, normalize, scale, type Vec3 } from '../math/vec3.ts';
import { gamma } from '../physics/lorentz/boost.ts';
import { accelerate, coast, type ObserverState } from '../physics/lorentz/observer.ts';
import { relativeVelocity } from '../physics/lorentz/velocity.ts';
import { boostOf, compose, properVelocityOf, relativeBoost } from './boost.ts';
import { accelerateFlight, coastFlight, type FlightState, flightOf, observerOf, wayAtSpeed } from './flightState.ts';

const c = 299_792_458;
const g = 9.80665;
const atRest: ObserverState = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, properTime: 0 };
const relative = (value: number, expected: number): number => Math.abs(value / expected - 1);

/** In units where c = a = 1: the rapidity gained is the proper time. */
const burn = (state: FlightState, along: Vec3, gained: number, steps = 1): FlightState => {
  let now = state;
  for (let i = 0; i < steps; i++) now = accelerateFlight(now, { direction: along, size: 1 }, gained / steps, 1);
  return now;
};

describe('a step of constant proper acceleration', () => {
  it('is that of physics/, at rapidities where squares of γβ keep their digits', () =>
    fc.assert(
      fc.property(properVelocityUpTo(30), direction, magnitude(-3, 0.4), uniform(0, 6), (u, n, gained, angle) => {
        const start = { ...atRest, u, orientation: fromAxisAngle([1, 2, 3], angle), t: 2, position: [3, 4, 5] as Vec3 };
        const expected = accelerate(start, scale(n, gained * 10), 1, 10);
        const end = observerOf(accelerateFlight(flightOf(start), { direction: n, size: gained * 10 }, 1, 10));
        const size = gamma(u) * Math.cosh(gained);
        expectClose(end.u, expected.u, 1e-13 * size);
        expectClose([end.t, ...end.position], [expected.t, ...expected.position], 1e-12 * size * size);
        expect(Math.abs(rotationAngle(multiply(end.orientation, conjugate(expected.orientation))))).toBeLessThan(1e-7);
        expectClose(rotate(end.orientation, [1, 0, 0]), rotate(expected.orientation, [1, 0, 0]), 1e-12 * size);
        expect(end.properTime).toBe(1);
      }),
    ));

  it('from rest at 1 g is x = c²/a (cosh aτ/c − 1), t = c/a sinh(aτ/c) to rapidity 300, in one step and in many', () => {
    for (const phi of [1e-6, 0.1, 1, 33, 150, 300])
      for (const steps of [1, 2000]) {
        const tau = (phi * c) / g;
        let ship = flightOf(atRest);
        for (let i = 0; i < steps; i++)
          ship = accelerateFlight(ship, { direction: [0, 0, 1], size: g }, tau / steps, c);
        const tolerance = 1e-13 * (1 + phi) * (steps === 1 ? 1 : 5);
        expect(relative(ship.velocity.rapidity, phi)).toBeLessThan(1e-13);
        expect(relative(ship.t.value, (c / g) * Math.sinh(phi))).toBeLessThan(tolerance);
        const x = ((2 * c * c) / g) * Math.sinh(phi / 2) ** 2;
        expect(relative(ship.position[2].value, x)).toBeLessThan(tolerance);
        expect(relative(ship.properTime.value, tau)).toBeLessThan(1e-15);
        expect(ship.orientation).toEqual(IDENTITY);
      }
  });

  it('brings twins together again: four burns of rapidity 33, in any direction, to 1e-12', () => {
    for (const n of [[1, 0, 0], [0.6, 0, -0.8], normalize([1, 2, 3])] as Vec3[])
      for (const steps of [1, 500]) {
        let ship = flightOf(atRest);
        for (const there of [n, negate(n), negate(n), n]) ship = burn(ship, there, 33, steps);
        expect(ship.velocity.rapidity).toBeLessThan(1e-12);
        expect(relative(ship.t.value, 4 * Math.sinh(33))).toBeLessThan(1e-12);
        const missed = Math.hypot(...ship.position.map(({ value }) => value));
        expect(missed / (2 * (Math.cosh(33) - 1))).toBeLessThan(1e-12);
        expect(relative(ship.properTime.value, 4 * 33)).toBeLessThan(1e-15);
      }
  });

  it('stops from rapidity 300, and flies on: the way is twice that of one half', () => {
    const half = burn(flightOf(atRest), [1, 0, 0], 300, 600);
    const ship = burn(half, [-1, 0, 0], 300, 600);
    expect(ship.velocity.rapidity).toBeLessThan(1e-11);
    expect(relative(ship.position[0].value, 2 * half.position[0].value)).toBeLessThan(1e-11);
    expect(relative(ship.t.value, 2 * half.t.value)).toBeLessThan(1e-11);
  });

  it('across the motion: φ′ = φ + ln(cosh δ + sinh δ cos θ) at the limit of high rapidity', () =>
    fc.assert(
      fc.property(direction, direction, uniform(30, 300), uniform(0.01, 3), (n, a, phi, delta) => {
        const end = compose({ direction: n, rapidity: phi }, { direction: a, rapidity: delta });
        const gained = Math.log(Math.cosh(delta) + Math.sinh(delta) * dot(n, a));
        expectClose(end.rapidity, phi + gained, 1e-12);
        expectClose(length(end.direction), 1, 1e-15);
      }),
    ));

  it('does not depend on the number of steps while a push is fixed to the gyroscopes', () =>
    fc.assert(
      fc.property(properVelocityUpTo(20), direction, uniform(0.1, 2), (u, thrust, gained) => {
        const [once, often] = [1, 20].map((steps) => {
          let ship = flightOf({ ...atRest, u });
          for (let i = 0; i < steps; i++) {
            const push = { direction: normalize(rotate(ship.orientation, thrust)), size: 1 };
            ship = accelerateFlight(ship, push, gained / steps, 1);
          }
          return observerOf(ship);
        });
        const size = gamma(once!.u) * gamma(u);
        expectClose(often!.u, once!.u, 1e-12 * size);
        expectClose([often!.t, ...often!.position], [once!.t, ...once!.position], 1e-12 * size);
        expectClose(rotate(often!.orientation, [0, 1, 0]), rotate(once!.orientation, [0, 1, 0]), 1e-11 * size);
      }),
    ));

  it('round a circle turns gyroscopes by the Thomas angle 2π(γ − 1), to 1e-5', () => {
    for (const factor of [1.01, 1.25, 2.2]) {
      const speed = Math.sqrt(1 - 1 / factor ** 2);
      // R = 1, c = 1: a proper acceleration of γ²β² across the motion, for the proper time 2π/(γβ).
      const size = factor ** 2 * speed ** 2;
      const steps = 40_000;
      const dTau = (2 * Math.PI) / (factor * speed) / steps;
      let ship = flightOf({ ...atRest, u: [factor * speed, 0, 0] });
      // cosh φ = cosh φ cosh δ + sinh φ sinh δ cos θ: a finite step keeps γ with a push that points back a little.
      const back = Math.tanh((size * dTau) / 2) / speed;
      let [turned, course] = [0, 0];
      for (let i = 0; i < steps; i++) {
        const [x, y] = ship.velocity.direction;
        const push = addScaled(scale([-y, x, 0], Math.sqrt(1 - back ** 2)), [x, y, 0], -back);
        const next = accelerateFlight(ship, { direction: normalize(push), size }, dTau, 1);
        turned += turn(rotate(ship.orientation, [1, 0, 0]), rotate(next.orientation, [1, 0, 0]));
        course += turn(ship.velocity.direction, next.velocity.direction);
        ship = next;
      }
      expectClose(ship.velocity.rapidity, Math.acosh(factor), 1e-9);
      expect(relative(course, 2 * Math.PI)).toBeLessThan(1e-5);
      expect(relative(ship.t.value, (2 * Math.PI) / speed)).toBeLessThan(1e-5);
      expectClose(observerOf(ship).position, [0, 0, 0], 1e-3);
      expect(relative(Math.abs(turned), 2 * Math.PI * (factor - 1))).toBeLessThan(1e-5);
      // Thomas precession is against the turn.
      expect(turned).toBeLessThan(0);
    }
  });
});

/** The angle from a to b, in the x-y plane [rad]. */
const turn = (a: Vec3, b: Vec3): number => Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);

describe('velocities as directions and rapidities', () => {
  it('are the same as proper velocities', () =>
    fc.assert(
      fc.property(properVelocityUpTo(1000), (u) =>
        expectClose(properVelocityOf(boostOf(u)), u, 4e-15 * length(u) * (1 + Math.asinh(length(u)))),
      ),
    ));

  it('relative to each other agree with physics/', () =>
    fc.assert(
      fc.property(properVelocityUpTo(20), properVelocityUpTo(20), (u, observer) => {
        const seen = properVelocityOf(relativeBoost(boostOf(u), boostOf(observer)));
        expectClose(seen, relativeVelocity(u, observer), 1e-13 * gamma(u) * gamma(observer));
      }),
    ));

  it('nearly against each other keep their digits: a side velocity stays as it was', () =>
    fc.assert(
      fc.property(direction, uniform(1, 12), magnitude(-6, -3), (n, phi, angle) => {
        const side = perpendicular(n);
        const back = normalize(addScaled(scale(n, -Math.cos(angle)), side, Math.sin(angle)));
        const u = properVelocityOf(compose({ direction: n, rapidity: phi }, { direction: back, rapidity: phi }));
        expectClose(dot(u, side) / (Math.sinh(phi) * Math.sin(angle)), 1, 1e-8);
      }),
    ));
});

describe('coasting', () => {
  it('is that of physics/, and the own clock goes on where γ overflows pictures', () => {
    const start = { ...atRest, u: [0.75, 0, 0] as Vec3 };
    expectClose(observerOf(coastFlight(flightOf(start), 4, 10)).position, coast(start, 4, 10).position, 1e-13);
    const fast = coastFlight(burn(flightOf(atRest), [1, 0, 0], 300), 2, 1);
    expect(fast.properTime.value).toBe(302);
    expect(relative(fast.t.value, Math.sinh(300) + 2 * Math.cosh(300))).toBeLessThan(1e-13);
  });

  it('adds small steps far from home without losing them', () => {
    let ship = flightOf({ ...atRest, t: 1e16, u: [0.75, 0, 0], position: [1e16, 0, 0] });
    for (let i = 0; i < 1000; i++) ship = coastFlight(ship, 0.04, 1);
    // Steps of 0.05 s and 0.03 m, where neighbouring numbers are 2 apart.
    expectClose([ship.t.value - 1e16, ship.position[0].value - 1e16], [50, 30], 1e-9);
  });
});

describe('the way of one who moves by his speed in his own time', () => {
  it('is the integral of cβ, along any motion', () =>
    fc.assert(
      fc.property(properVelocityUpTo(20), direction, uniform(0.01, 4), (u, n, gained) => {
        const push = { direction: n, size: 5 };
        const [duration, steps] = [(gained * 10) / 5, 400];
        const beta = (tau: number): Vec3 => {
          const { velocity } = accelerateFlight(flightOf({ ...atRest, u }), push, tau, 10);
          return scale(velocity.direction, Math.tanh(velocity.rapidity));
        };
        // Simpson's rule.
        let sum: Vec3 = [0, 0, 0];
        for (let i = 0; i <= steps; i++) {
          const weight = i === 0 || i === steps ? 1 : i % 2 === 1 ? 4 : 2;
          sum = addScaled(sum, beta((duration * i) / steps), (weight * 10 * duration) / steps / 3);
        }
        expectClose(wayAtSpeed(boostOf(u), push, duration, 10), sum, 1e-5 * duration);
      }),
      { numRuns: 50 },
    ));

  it('from rest and back is (c²/a) ln cosh φ, also at 1 g in a sixtieth of a second and to rapidity 300', () => {
    const along: Vec3 = [0, 0, 1];
    for (const phi of [g / 60 / c, 1e-3, 1, 30, 300]) {
      const push = { direction: along, size: g };
      // ln cosh φ = ½ ln(1 + sinh²φ), which is φ − ln 2 where sinh²φ has no room for the 1.
      const expected = ((c * c) / g) * (phi < 20 ? Math.log1p(Math.sinh(phi) ** 2) / 2 : phi - Math.LN2);
      const there = wayAtSpeed({ direction: along, rapidity: 0 }, push, (phi * c) / g, c);
      expect(relative(there[2], expected)).toBeLessThan(1e-12);
      const back = { direction: negate(along), size: g };
      expect(
        relative(wayAtSpeed({ direction: along, rapidity: phi }, back, (phi * c) / g, c)[2], expected),
      ).toBeLessThan(1e-12);
    }
  });
});
