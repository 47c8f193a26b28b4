import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AT_REST, FLIGHT_RULES } from '../../../tests/support/flightFixtures.ts';
import { IDENTITY } from '../../math/quat.ts';
import { length, sub } from '../../math/vec3.ts';
import { gamma, velocity } from '../../physics/lorentz/boost.ts';
import type { ObserverState } from '../../physics/lorentz/observer.ts';
import { type FlightConditions, flyArcs } from '../arc.ts';
import { type FlightControls, type FlightRules, NO_CONTROLS } from '../controls.ts';
import { flightOf, observerOf } from '../flightState.ts';
import { arcsOf } from '../step.ts';
import { velocityMode, walkingSpeed } from './velocity.ts';

const rest = AT_REST;
type Rules = FlightRules & FlightConditions;
const rules: Rules = { ...FLIGHT_RULES, c: 30, maxSpeed: 0.9, lock: 'free', playing: true };
const forward: FlightControls = { ...NO_CONTROLS, thrust: [0, 0, -1] };
const sprint: FlightControls = { ...forward, fullSpeed: true };

function fly(state: ObserverState, controls: FlightControls, seconds: number, by: Rules = rules, dt = 1 / 60) {
  const speeds = [];
  let now = flightOf(state);
  for (let time = 0; time < seconds - 1e-9; time += dt) {
    now = flyArcs(now, arcsOf(velocityMode, { state: now, controls, dt, rules: by }), by);
    speeds.push(length(velocity(observerOf(now).u)));
  }
  return { now: observerOf(now), speeds };
}
const rising = (values: number[]) => values.every((value, i) => i === 0 || value >= values[i - 1]! - 1e-12);

describe('flight', () => {
  it('moves at the smaller of half the maximum speed and 8 m/s', () => {
    expect(walkingSpeed(rules)).toBeCloseTo(8 / 30, 12);
    expect(walkingSpeed({ c: 10, maxSpeed: 0.9 })).toBeCloseTo(0.45, 12);
    const { now, speeds } = fly(rest, forward, 1);
    expect(speeds.at(-1)).toBeCloseTo(8 / 30, 12);
    expect(rising(speeds)).toBe(true);
    expect(speeds[5]).toBeLessThan(0.1);
    expect(now.position[2]).toBeLessThan(-4);
  });

  it('reaches the maximum speed with Shift in 2 s of proper time, smoothly, and never exceeds it', () => {
    const { now, speeds } = fly(rest, sprint, 2.1);
    expect(speeds[100]).toBeLessThan(0.9);
    expect(speeds.at(-1)).toBeCloseTo(0.9, 12);
    expect(rising(speeds)).toBe(true);
    expect(Math.max(...speeds)).toBeLessThanOrEqual(0.9 + 1e-12);
    // Constant proper acceleration: βγ = sinh(aτ/c), so halfway through the burn the rapidity is half of it.
    expect(speeds[59]).toBeCloseTo(Math.tanh(Math.atanh(0.9) / 2), 6);
    expect(now.properTime).toBeCloseTo(2.1, 9);
    expect(now.t).toBeGreaterThan(2.1);
  });

  it('brakes to rest without keys, and keeps its velocity in cruise mode', () => {
    const { now } = fly(rest, sprint, 3);
    expect(length(fly(now, NO_CONTROLS, 3).now.u)).toBe(0);
    expect(fly(now, NO_CONTROLS, 3, { ...rules, cruise: true }).now.u).toEqual(now.u);
  });

  it('lock look: has a velocity without moving, and its clock runs slow', () => {
    const { now } = fly(rest, sprint, 4, { ...rules, lock: 'look' });
    expect(now.position).toEqual([0, 0, 0]);
    expect(length(velocity(now.u))).toBeCloseTo(0.9, 9);
    expect(now.t).toBeCloseTo(4, 9);
    expect(now.properTime).toBeLessThan(3.5);
  });

  it('lock fly: moves at its speed in world time', () => {
    const fast = fly(rest, sprint, 3, { ...rules, lock: 'fly' }).now;
    const later = fly(fast, sprint, 1, { ...rules, lock: 'fly' }).now;
    expect(length(sub(later.position, fast.position))).toBeCloseTo(0.9 * 30, 6);
    expect(later.t - fast.t).toBeCloseTo(1, 9);
    expect(later.orientation).toEqual(IDENTITY);
  });

  it('moves through a frozen instant while time is paused', () => {
    const { now } = fly(rest, sprint, 2, { ...rules, playing: false });
    expect(now.t).toBe(0);
    expect(now.properTime).toBe(0);
    expect(now.position[2]).toBeLessThan(-10);
  });

  it('does not depend on the frame rate', () => {
    const coarse = fly(rest, sprint, 1.5, rules, 0.1).now;
    const fine = fly(rest, sprint, 1.5, rules, 0.005).now;
    expect(length(sub(coarse.position, fine.position))).toBeLessThan(1e-9);
  });

  it('stays finite and subluminal for any controls', () => {
    const axis = fc.double({ min: -1, max: 1, noNaN: true });
    const thrust = fc.tuple(axis, axis, axis);
    const controls = fc.record({ thrust, turn: thrust, fullSpeed: fc.boolean(), brake: fc.boolean() });
    fc.assert(
      fc.property(
        fc.array(controls, { minLength: 1, maxLength: 20 }),
        fc.constantFrom('free', 'look', 'fly'),
        fc.constantFrom(0.1, 30, 299_792_458),
        (sequence, lock, c) => {
          let flight = flightOf(rest);
          const by: Rules = { ...rules, lock, c, maxSpeed: 0.999999 };
          for (const one of sequence)
            flight = flyArcs(flight, arcsOf(velocityMode, { state: flight, controls: one, dt: 0.1, rules: by }), by);
          const state = observerOf(flight);
          expect([...state.position, ...state.u, ...state.orientation, state.t].every(Number.isFinite)).toBe(true);
          expect(gamma(state.u)).toBeLessThan(708);
        },
      ),
    );
  });
});
