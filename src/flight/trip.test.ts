import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, expectClose, magnitude } from '../../tests/support/physicsArbitraries.ts';
import { IDENTITY } from '../math/quat.ts';
import { length, negate, normalize, scale, sub, type Vec3 } from '../math/vec3.ts';
import type { ObserverState } from '../physics/lorentz/observer.ts';
import { type FlightConditions, flyArc, flyArcs } from './arc.ts';
import { flightOf, observerOf } from './flightState.ts';
import { durationOf, planTrip } from './trip.ts';

const rest: ObserverState = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, properTime: 0 };
const relative = (value: number, expected: number): number => Math.abs(value / expected - 1);
/** In years and light-years: 1 g is 1.03227 light-years a year². */
const g = (9.80665 * 31_557_600) / 299_792_458;
const years: FlightConditions = { c: 1, lock: 'free', playing: true };
const unlimited = { c: 1, acceleration: g, limit: 300 };

describe('a trip at 1 g', () => {
  it.each([
    // Misner, Thorne & Wheeler, exercise 6.3; Wikipedia, "Space travel under constant acceleration".
    ['the nearest star', 4.3, 3.6, 5.93],
    ['Vega', 27, 6.6, 28.9],
    ['the centre of the galaxy', 30_000, 20, 30_002],
    ['the galaxy in Andromeda', 2_000_000, 28, 2_000_002],
  ])('to %s takes what books say', (_, d, own, world) => {
    const arcs = planTrip(flightOf(rest), [0, 0, -d], unlimited);
    const end = flyArcs(flightOf(rest), arcs, years);
    expect(relative(durationOf(arcs), own)).toBeLessThan(0.02);
    expect(relative(end.t.value, world)).toBeLessThan(0.005);
  });

  it('agrees with its closed forms to 1e-12, over 27 powers of ten', () =>
    fc.assert(
      fc.property(direction, magnitude(-3, 24), (n, d) => {
        const arcs = planTrip(flightOf(rest), scale(n, d), unlimited);
        const end = flyArcs(flightOf(rest), arcs, years);
        // In units of c²/a: τ = 2 acosh(1 + d/2), t = √(d² + 4d).
        const x = d * g;
        const tau = 4 * Math.asinh(Math.sqrt(x / 4));
        expect(relative(durationOf(arcs) * g, tau)).toBeLessThan(1e-12);
        expect(relative(end.properTime.value * g, tau)).toBeLessThan(1e-12);
        expect(relative(end.t.value * g, Math.sqrt(x * x + 4 * x))).toBeLessThan(1e-12);
        expect(length(sub(observerOf(end).position, scale(n, d))) / d).toBeLessThan(1e-12);
        expect(end.velocity.rapidity).toBe(0);
      }),
    ));

  it('and back leaves a twin younger than the other: rapidity 33 a leg, to 1e-12', () => {
    const n = normalize([1, 2, 3]);
    const d = 2 * (Math.cosh(33) - 1);
    const rules = { c: 1, acceleration: 1, limit: 300 };
    const there = flyArcs(flightOf(rest), planTrip(flightOf(rest), scale(n, d), rules), years);
    const home = flyArcs(there, planTrip(there, [0, 0, 0], rules), years);
    expect(relative(home.properTime.value, 4 * 33)).toBeLessThan(1e-12);
    expect(relative(home.t.value, 4 * Math.sinh(33))).toBeLessThan(1e-12);
    expect(length(observerOf(home).position) / d).toBeLessThan(1e-12);
    expect(home.velocity.rapidity).toBe(0);
  });

  it('coasts at its limit, with 2 sinh φ for the acceleration and its end', () => {
    const [limit, d] = [1.5, 50];
    const arcs = planTrip(flightOf(rest), [d, 0, 0], { c: 1, acceleration: 1, limit });
    expect(arcs).toHaveLength(3);
    const end = flyArcs(flightOf(rest), arcs, years);
    const coasted = (d - 2 * (Math.cosh(limit) - 1)) / Math.tanh(limit);
    expectClose(end.t.value, 2 * Math.sinh(limit) + coasted, 1e-12);
    expectClose(end.position[0].value, d, 1e-12);
    expectClose(flyArc(flightOf(rest), arcs[0]!, years).velocity.rapidity, limit, 1e-15);
  });

  it('stops first where it flies away or too fast, and then comes back', () => {
    const rules = { c: 1, acceleration: 1, limit: 300 };
    const [u, direction]: [Vec3, Vec3] = [
      [3, 0, 0],
      [1, 0, 0],
    ];
    const start = flightOf({ ...rest, u });
    // (γ − 1)c²/a
    const stop = Math.hypot(1, 3) - 1;
    for (const d of [-5, 0.5 * stop]) {
      const arcs = planTrip(start, [d, 0, 0], rules);
      expect(arcs[0]!.push!.direction).toEqual(negate(direction));
      expectClose(arcs[0]!.dTau, Math.asinh(3), 1e-14);
      const end = flyArcs(start, arcs, years);
      expectClose(end.position[0].value, d, 1e-13);
      expectClose(durationOf(arcs), Math.asinh(3) + 4 * Math.asinh(Math.sqrt((stop - d) / 4)), 1e-13);
    }
  });
});
