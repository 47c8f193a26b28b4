import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  direction,
  expectClose,
  magnitude,
  perpendicular,
  properVelocityUpTo,
  uniform,
} from '../../../tests/support/physicsArbitraries.ts';
import { conjugate, fromAxisAngle, IDENTITY, type Quat, rotate, rotationAngle } from '../../math/quat.ts';
import { cross, dot, length, negate, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { positionAt, type WorldLine } from '../worldLines/worldLine.ts';
import { boost, gamma, inverseBoost, properVelocity, rapidity, velocity } from './boost.ts';
import { fourVector, minkowskiDot } from './fourVector.ts';
import { accelerate, coast, type ObserverState } from './observer.ts';
import { wignerRotation } from './velocity.ts';

const c = 10;
const atRest: ObserverState = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, properTime: 0 };
const moving = (u: Vec3): ObserverState => ({ ...atRest, u });
const orientation: fc.Arbitrary<Quat> = fc
  .tuple(direction, uniform(0, 6))
  .map(([axis, angle]) => fromAxisAngle(axis, angle));

/** Steps with thrust fixed in camera axes, as a rocket's, and so in gyroscope axes. */
function fly(start: ObserverState, thrustInCamera: Vec3, dTau: number, steps: number): ObserverState {
  let state = start;
  for (let i = 0; i < steps; i++) state = accelerate(state, rotate(state.orientation, thrustInCamera), dTau / steps, c);
  return state;
}

describe('constant proper acceleration', () => {
  it('from rest is the hyperbola: v = c tanh(aτ/c), t = (c/a) sinh(aτ/c), x by its world line', () =>
    fc.assert(
      fc.property(direction, magnitude(-6, 1), magnitude(-6, 1), (n, a, tau) => {
        const end = accelerate(atRest, scale(n, a), tau, c);
        const eta = (a * tau) / c;
        fc.pre(eta < 8);
        const tolerance = 1e-14 * Math.cosh(eta) ** 2;
        expectClose(velocity(end.u), scale(n, Math.tanh(eta)), 1e-15 + 1e-15 * eta);
        expectClose(end.t / ((c / a) * Math.sinh(eta)), 1, tolerance);
        const rocket: WorldLine = { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: scale(n, a), t0: 0 };
        const place = positionAt(rocket, end.t, c);
        expectClose(end.position, place, tolerance * length(place));
        expect(end.properTime).toBe(tau);
        expectClose(end.orientation, IDENTITY, 1e-15);
      }),
    ));
  it('of 1 g for a year of proper time reaches 0.77 c', () => {
    const year = 365.25 * 86400;
    const end = accelerate(atRest, [0, 0, 9.80665], year, 299792458);
    // Misner, Thorne & Wheeler §6.2: 1.19 years of world time, 0.56 light years of distance.
    expect(velocity(end.u)[2]).toBeCloseTo(0.7746, 3);
    expect(end.t / year).toBeCloseTo(1.187, 2);
    expect(end.position[2] / (299792458 * year)).toBeCloseTo(0.563, 2);
  });
  it('is the boosted hyperbola of the initial rest frame', () =>
    fc.assert(
      fc.property(properVelocityUpTo(50), direction, magnitude(-3, 1), magnitude(-3, 1), (u, n, a, tau) => {
        const eta = (a * tau) / c;
        const l = (c * c) / a;
        const end = accelerate(moving(u), scale(n, a), tau, c);
        const X = inverseBoost(fourVector(l * Math.sinh(eta), scale(n, l * (Math.cosh(eta) - 1))), u);
        // The reference loses digits in cosh ζ − 1 where ζ is small.
        const tolerance = 1e-13 * gamma(u) * l * Math.cosh(eta);
        expectClose([c * end.t, ...end.position], X, tolerance);
      }),
    ));
  it('gives the interval (cΔt)² − Δx² = (2c²/a · sinh(aτ/2c))²', () =>
    fc.assert(
      fc.property(properVelocityUpTo(1000), direction, magnitude(-3, 1), magnitude(-3, 0), (u, n, a, tau) => {
        const end = accelerate(moving(u), scale(n, a), tau, c);
        const X = fourVector(c * end.t, end.position);
        const straight = ((2 * c * c) / a) * Math.sinh((a * tau) / (2 * c));
        expectClose(Math.sqrt(-minkowskiDot(X, X)) / straight, 1, 1e-14 * ((c * end.t) / straight) ** 2);
      }),
    ));
  it('in many steps along a line equals one step', () =>
    fc.assert(
      fc.property(
        direction,
        uniform(-6, 6),
        uniform(-6, 6),
        fc.integer({ min: 2, max: 40 }),
        (n, zeta, gained, steps) => {
          const start = moving(scale(n, Math.sinh(zeta)));
          const [once, often] = [1, steps].map((k) => fly(start, scale(n, gained * c), 1, k));
          const size = Math.cosh(Math.abs(zeta) + Math.abs(gained));
          expectClose(often.u, once.u, 1e-13 * size);
          expectClose(often.t, once.t, 1e-13 * size * c);
          expectClose(often.position, once.position, 1e-13 * size * c);
          expectClose(rapidity(often.u), Math.abs(zeta + gained), 1e-12 * size);
          expectClose(often.orientation, IDENTITY, 1e-12);
        },
      ),
    ));
  it('in any direction in many steps equals one step, if the thrust is fixed relative to gyroscopes', () =>
    fc.assert(
      fc.property(properVelocityUpTo(8), direction, uniform(0, 2), orientation, (u, n, gained, q) => {
        const start = { ...moving(u), orientation: q };
        const [once, often] = [1, 25].map((k) => fly(start, scale(n, gained * c), 1, k));
        expectClose(often.u, once.u, 1e-11 * gamma(once.u));
        expectClose(often.position, once.position, 1e-11 * gamma(once.u) * c);
        expectClose(often.t, once.t, 1e-11 * gamma(once.u));
        expectClose(rotationAngleBetween(often.orientation, once.orientation), 0, 1e-11);
      }),
    ));
  it('is inverted by a step of negative proper time', () =>
    fc.assert(
      fc.property(properVelocityUpTo(20), direction, uniform(0, 2), orientation, (u, n, gained, q) => {
        const start = { ...moving(u), orientation: q };
        const back = fly(fly(start, scale(n, gained * c), 1, 1), scale(n, gained * c), -1, 1);
        expectClose([...back.u, ...back.position, back.t], [...u, 0, 0, 0, 0], 1e-10 * gamma(u));
        expectClose(back.orientation, q, 1e-11 * gamma(u));
        expect(back.properTime).toBe(0);
      }),
    ));
  it('without acceleration is uniform motion, and without time the identity', () =>
    fc.assert(
      fc.property(properVelocityUpTo(1000), orientation, (u, q) => {
        const start = { ...moving(u), orientation: q };
        const [drift, free] = [accelerate(start, [0, 0, 0], 2, c), coast(start, 2, c)];
        expectClose([drift.t, ...drift.position, ...drift.u], [free.t, ...free.position, ...free.u], 1e-12 * gamma(u));
        const still = accelerate(start, [1, 2, 3], 0, c);
        expectClose([still.t, ...still.position, ...still.u], [0, 0, 0, 0, ...u], 0);
        expectClose(still.orientation, q, 1e-15);
      }),
    ));
  it('is aτ/c and aτ²/2 for small accelerations', () => {
    const end = accelerate(atRest, [1e-12, 0, 0], 1e-9, c);
    expectClose(end.u[0] / 1e-22, 1, 1e-14);
    expectClose(end.position[0] / 5e-31, 1, 1e-14);
    expectClose(end.t / 1e-9, 1, 1e-15);
  });
  it('brakes from γ = 1000 to rest', () => {
    const zeta = Math.acosh(1000);
    const end = accelerate(moving([0, 0, Math.sinh(zeta)]), [0, 0, -zeta * c], 1, c);
    expectClose(end.u, [0, 0, 0], 1e-12);
    // The start in reverse: x = c²/a (cosh ζ − 1), t = c/a sinh ζ.
    expectClose(end.position[2] / ((c / zeta) * 999), 1, 1e-12);
    expectClose(end.t / (Math.sinh(zeta) / zeta), 1, 1e-12);
  });
});

/** The angle between two orientations [rad]. */
function rotationAngleBetween(a: Quat, b: Quat): number {
  const e: Vec3[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  return Math.max(...e.map((x) => length(cross(rotate(a, x), rotate(b, x)))));
}

describe('the camera’s axes', () => {
  it('rotate back by the Wigner rotation: a gyroscope keeps its axes under B(u₂)B(u₁)', () =>
    fc.assert(
      fc.property(
        properVelocityUpTo(30),
        direction,
        magnitude(-2, 1),
        orientation,
        direction,
        (u, n, zeta, q, axis) => {
          fc.pre(zeta < 4);
          const end = accelerate({ ...moving(u), orientation: q }, scale(n, zeta * c), 1, c);
          // The gyroscope's axis as a four-vector: boosted back to the world it is the same by both routes.
          const inGyro = fourVector(0, rotate(q, axis));
          const world = inverseBoost(inverseBoost(inGyro, scale(n, Math.sinh(zeta))), u);
          const byEnd = inverseBoost(fourVector(0, rotate(end.orientation, axis)), end.u);
          expectClose(byEnd, world, 1e-12 * (gamma(u) * Math.cosh(zeta)) ** 2);
        },
      ),
    ));
  it('show Thomas precession: dθ = −γ²/(γ + 1) a × β … dτ for a small perpendicular push', () =>
    fc.assert(
      fc.property(uniform(0.1, 0.99), direction, uniform(0, 6), (beta, m, phi) => {
        const n = perpendicular(m, phi);
        const [u, push] = [properVelocity(scale(m, beta)), 1e-6];
        const end = accelerate(moving(u), scale(n, push * c), 1, c);
        // Jackson (11.119) in proper velocities: the rotation is |u| ζ/(γ + 1) for a gain of rapidity ζ perpendicular to u.
        const expected = (length(u) * push) / (gamma(u) + 1);
        expectClose(rotationAngle(end.orientation) / expected, 1, 1e-5);
        // The rotation axis is push × u: opposite to the rotation of the velocity.
        const axis = normalize([end.orientation[0], end.orientation[1], end.orientation[2]]);
        expectClose(axis, normalize(cross(n, u)), 1e-5);
      }),
    ));
  it('are rotated after a closed circle of pushes, by the area in velocity space', () => {
    // Twelve thousand small pushes rotate u once at constant γ: the Thomas angle is 2π(γ − 1).
    const u0 = properVelocity([0.6, 0, 0]);
    const steps = 12000;
    let state = moving(u0);
    for (let i = 0; i < steps; i++) {
      // Push perpendicular to the velocity, in the boosted axes, at the middle of the step.
      const angle = (2 * Math.PI * (i + 0.5)) / steps;
      const turn = 2 * Math.asin(length(u0) * Math.sin(Math.PI / steps));
      state = accelerate(state, [-turn * c * Math.sin(angle), turn * c * Math.cos(angle), 0], 1, c);
    }
    expectClose(state.u, u0, 1e-4);
    const expected = 2 * Math.PI * (gamma(u0) - 1);
    expectClose(rotate(state.orientation, [1, 0, 0]), [Math.cos(expected), -Math.sin(expected), 0], 1e-3);
  });
  it('agree with the rotation of velocity.ts', () => {
    const [u, push] = [properVelocity([0.6, 0, 0]), [0, 8, 0] as Vec3];
    const end = accelerate(moving(u), push, 1, c);
    expectClose(end.orientation, conjugate(wignerRotation(u, [0, Math.sinh(0.8), 0])), 1e-15);
  });
});

describe('the clocks', () => {
  it('of the world runs γ times as fast as the observer’s', () => {
    const end = coast(moving([0.75, 0, 0]), 4, c);
    expect([end.t, end.properTime, end.position[0]]).toEqual([5, 4, 30]);
  });
  it('of twins differ after a return trip', () => {
    // Out and back in four equal burns of rapidity 2: world time 4 sinh 2, proper time 8, in units of c/a.
    let ship = atRest;
    for (const thrust of [1, -1, -1, 1]) ship = accelerate(ship, [thrust, 0, 0], 2 * c, c);
    expectClose(ship.u, [0, 0, 0], 1e-13);
    expectClose(ship.position, [0, 0, 0], 1e-11);
    expectClose(ship.t, 4 * c * Math.sinh(2), 1e-11);
    expect(ship.properTime).toBe(8 * c);
  });
  it('four-velocity stays normalised over a long flight', () => {
    let ship = moving([0.3, -0.2, 0.1]);
    for (let i = 0; i < 500; i++) ship = accelerate(ship, [Math.sin(i), Math.cos(2 * i), Math.sin(3 * i)], 1, c);
    const rest = boost(fourVector(gamma(ship.u), ship.u), ship.u);
    expectClose(rest, [1, 0, 0, 0], 1e-12);
    expectClose(dot(ship.u, negate(ship.u)), -(gamma(ship.u) ** 2 - 1), 1e-12);
    expectClose(Math.hypot(...ship.orientation), 1, 1e-15);
  });
});
