import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AT_REST, FLIGHT_RULES, FREELY } from '../../../tests/support/flightFixtures.ts';
import {
  direction,
  expectClose,
  magnitude,
  properVelocityUpTo,
  uniform,
} from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, rotate } from '../../math/quat.ts';
import { addScaled, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { gamma } from '../../physics/lorentz/boost.ts';
import { accelerate, coast } from '../../physics/lorentz/observer.ts';
import { relativeVelocity } from '../../physics/lorentz/velocity.ts';
import { flyArcs } from '../arc.ts';
import { boostOf, properVelocityOf } from '../boost.ts';
import { type FlightControls, type FlightRules, NO_CONTROLS } from '../controls.ts';
import { type FlightState, flightOf, observerOf } from '../flightState.ts';
import { arcsOf } from '../step.ts';
import { NOSE } from '../turning.ts';
import { FLIGHT_MODES, type FlightModeName } from './modes.ts';

const [rest, rules] = [AT_REST, FLIGHT_RULES];

function fly(
  mode: FlightModeName,
  start: FlightState,
  controls: Partial<FlightControls>,
  seconds: number,
  by: Partial<FlightRules> = {},
  steps = Math.ceil(seconds * 60),
): FlightState {
  let state = start;
  const dt = seconds / steps;
  for (let i = 0; i < steps; i++) {
    const moment = { state, controls: { ...NO_CONTROLS, ...controls }, dt, rules: { ...rules, ...by } };
    state = flyArcs(state, arcsOf(FLIGHT_MODES[mode], moment), FREELY);
  }
  return state;
}

describe('every mode', () => {
  it.each(Object.keys(FLIGHT_MODES) as FlightModeName[])('%s takes just its time, and stays below its limit', (mode) =>
    fc.assert(
      fc.property(
        properVelocityUpTo(2),
        direction,
        uniform(0, 1),
        direction,
        fc.boolean(),
        magnitude(-3, 0),
        (u, thrust, amount, turn, brake, dt) => {
          const state = flightOf({ ...rest, u, orientation: fromAxisAngle(turn, amount) });
          const controls = { thrust: scale(thrust, amount), turn: scale(turn, dt), fullSpeed: true, brake };
          const near: FlightRules = { ...rules, destination: [3, 4, 5], followed: boostOf([0.3, 0, 0.2]) };
          const arcs = arcsOf(FLIGHT_MODES[mode], { state, controls, dt, rules: near });
          expectClose(
            arcs.reduce((sum, { dTau }) => sum + dTau, 0),
            dt,
            1e-15,
          );
          for (const { dTau, push } of arcs) {
            expect(dTau).toBeGreaterThanOrEqual(0);
            if (push) expectClose(length(push.direction), 1, 1e-14);
          }
          const { rapidity } = flyArcs(state, arcs, FREELY).velocity;
          expect(rapidity).toBeLessThanOrEqual(Math.max(Math.atanh(rules.maxSpeed), state.velocity.rapidity) + 1e-12);
        },
      ),
    ),
  );
});

describe('thrust', () => {
  const orientation = fromAxisAngle([1, 2, -1], 0.8);

  it('is a constant proper acceleration along the axes of the ship, along and across apart', () => {
    for (const [thrust, size] of [
      [[0, 0, -1], 5],
      [[1, 0, 0], 2],
      [[0, -0.5, 0], 1],
    ] as [Vec3, number][]) {
      const push = scale(rotate(orientation, normalize(thrust)), size);
      const expected = accelerate({ ...rest, orientation }, push, 0.7, 10);
      const end = observerOf(fly('thrust', flightOf({ ...rest, orientation }), { thrust }, 0.7));
      expectClose(end.u, expected.u, 1e-12);
      expectClose(end.position, expected.position, 1e-12);
      expectClose([end.t, end.properTime], [expected.t, 0.7], 1e-12);
    }
  });

  it('coasts when let go, and brakes to a stop', () => {
    const start = { ...rest, orientation, u: [0.6, 1, -0.2] as Vec3 };
    const drifting = observerOf(fly('thrust', flightOf(start), {}, 2));
    expectClose(drifting.position, coast(start, 2, 10).position, 1e-11);
    const stopped = fly('thrust', flightOf(start), { brake: true }, 3);
    expect(stopped.velocity.rapidity).toBe(0);
    // (γ − 1)c²/a, the way in which a motion of constant proper acceleration ends at rest.
    expectClose(length(observerOf(stopped).position), ((gamma(start.u) - 1) * 100) / 5, 1e-11);
  });

  it('coasts at the limit, where its own clock goes on', () => {
    const limit = Math.atanh(rules.maxSpeed);
    const atLimit = fly('thrust', flightOf(rest), { thrust: [0, 0, -1] }, 20);
    expectClose(atLimit.velocity.rapidity, limit, 1e-12);
    expectClose(atLimit.properTime.value, 20, 1e-12);
    const burn = (limit * 10) / 5;
    const t = (10 / 5) * Math.sinh(limit) + Math.cosh(limit) * (20 - burn);
    expectClose(atLimit.t.value, t, 1e-10);
  });

  it('still steers at the limit: the motion turns, and its rapidity stays', () => {
    const fast = flightOf({ ...rest, u: scale([0, 0, -1], Math.sinh(Math.atanh(rules.maxSpeed))) });
    const turned = fly('thrust', fast, { thrust: [1, 0, -1] }, 0.05);
    expectClose(turned.velocity.rapidity, Math.atanh(rules.maxSpeed), 1e-11);
    // At constant speed a push a across turns the course by a/(γβc) per proper time; gyroscopes hardly turn in so short a time.
    const course = Math.atan2(turned.velocity.direction[0], -turned.velocity.direction[2]);
    const { c, across } = rules;
    expect(Math.abs(course / (across / (gamma(observerOf(fast).u) * rules.maxSpeed * c)) / 0.05 - 1)).toBeLessThan(
      0.02,
    );
  });

  it('turns about all axes of the ship, and keeps its horizon only when asked to', () => {
    const rolled = fly('thrust', flightOf(rest), { turn: [0, 0, 0.01] }, 1, {}, 60);
    expectClose(rotate(rolled.orientation, [0, 1, 0]), [-Math.sin(0.6), Math.cos(0.6), 0], 1e-12);
    const level = fly('thrust', rolled, {}, 1, { level: true });
    expectClose(rotate(level.orientation, [0, 1, 0]), [0, 1, 0], 1e-9);
  });

  it.each([
    ['motion', 1],
    ['against', -1],
  ] as const)('holds its nose: %s', (attitude, sign) => {
    const moving = flightOf({ ...rest, u: [1, 0.2, 0.4] });
    const held = fly('thrust', moving, {}, 6, { attitude });
    expectClose(rotate(held.orientation, NOSE), scale(held.velocity.direction, sign), 1e-6);
  });
});

describe('vehicle', () => {
  it('turns its nose into the motion, and its tail while it goes backwards', () => {
    const sideways = fly('vehicle', flightOf({ ...rest, u: [0.5, 0, -0.1] }), {}, 4);
    expectClose(rotate(sideways.orientation, NOSE), sideways.velocity.direction, 1e-4);
    const back = fly('vehicle', flightOf({ ...rest, u: [0.1, 0, 0.5] }), {}, 4);
    expectClose(rotate(back.orientation, NOSE), scale(back.velocity.direction, -1), 1e-4);
  });
});

describe('drive', () => {
  it('stays at its height wherever one looks, and loses a vertical velocity', () => {
    const looking = fromAxisAngle([1, 0, 0], -1.2);
    const end = observerOf(fly('drive', flightOf({ ...rest, orientation: looking }), { thrust: [0.3, 1, -1] }, 3));
    expectClose(end.position[1], 0, 1e-12);
    expect(end.position[2]).toBeLessThan(-1);
    const falling = observerOf(fly('drive', flightOf({ ...rest, u: [0, -0.4, 0] }), {}, 3));
    expectClose(falling.u, [0, 0, 0], 1e-12);
  });
});

describe('follow', () => {
  it('ends in the rest frame of the body, where the keys move one as they do in the world', () =>
    fc.assert(
      fc.property(properVelocityUpTo(1.5), properVelocityUpTo(1.5), (u, body) => {
        const still = fly('follow', flightOf({ ...rest, u }), {}, 8, { followed: boostOf(body) });
        expectClose(properVelocityOf(still.velocity), body, 1e-12);
        const walking = fly('follow', still, { thrust: [0, 0, -1] }, 3, { followed: boostOf(body) });
        const speed = length(relativeVelocity(properVelocityOf(walking.velocity), body));
        expectClose(Math.tanh(Math.asinh(speed)), rules.maxSpeed / 2, 1e-10);
      }),
      { numRuns: 20 },
    ));
});

describe('autopilot', () => {
  it('arrives at rest after the proper time of the closed form, in steps of any size', () => {
    for (const seconds of [1 / 60, 0.31]) {
      const destination: Vec3 = [30, -20, 60];
      const by = { destination, maxSpeed: 1 - 1e-12 };
      const d = length(destination);
      const tau = ((2 * 10) / 5) * Math.acosh(1 + (5 * d) / 2 / 100);
      let [state, steps] = [flightOf(rest), 0];
      while (steps * seconds < tau) {
        state = fly('autopilot', state, {}, seconds, by, 1);
        steps++;
      }
      expectClose(observerOf(state).position, destination, 1e-9);
      expect(state.velocity.rapidity).toBeLessThan(1e-6);
      // Before the last step it was on its way.
      expect((steps - 1) * seconds).toBeLessThan(tau);
    }
  });

  it('stops first where it flies elsewhere, and arrives all the same', () =>
    fc.assert(
      fc.property(properVelocityUpTo(1.5), direction, uniform(0, 100), (u, there, distance) => {
        const destination = addScaled([1, 2, 3], there, distance);
        const end = fly('autopilot', flightOf({ ...rest, u }), {}, 120, { destination }, 400);
        expect(length(sub(observerOf(end).position, destination))).toBeLessThan(1e-9);
        expect(end.velocity.rapidity).toBeLessThan(1e-6);
      }),
      { numRuns: 20 },
    ));

  it('turns around half way, if its nose points where its engine pushes', () => {
    const by = { destination: [0, 0, -400] as Vec3, attitude: 'push' as const };
    expect(dot(rotate(fly('autopilot', flightOf(rest), {}, 2, by).orientation, NOSE), [0, 0, -1])).toBeGreaterThan(
      0.99,
    );
    expect(dot(rotate(fly('autopilot', flightOf(rest), {}, 12, by).orientation, NOSE), [0, 0, -1])).toBeLessThan(-0.9);
  });
});
