import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, magnitude, properVelocityUpTo, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { type FlightConditions, flyArcs } from '../../flight/arc.ts';
import { type FlightState, flightOf, observerOf } from '../../flight/flightState.ts';
import { FlightPlayback } from '../../flight/recording/playback.ts';
import { planTrip } from '../../flight/trip.ts';
import { IDENTITY } from '../../math/quat.ts';
import { addScaled, negate, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { boost, gamma, properVelocity, velocity } from '../../physics/lorentz/boost.ts';
import type { FourVector } from '../../physics/lorentz/fourVector.ts';
import { relativeVelocity } from '../../physics/lorentz/velocity.ts';
import { IDENTITY_POSE, makeObject, restingAt } from '../defaults.ts';
import { box } from '../mesh/primitives.ts';
import type { Motion, SceneObject } from '../types.ts';
import { type Clock, clockTime, objectClocks } from './clock.ts';
import {
  type ClockAbsence,
  type ClockReading,
  type ClockReadings,
  ownReadings,
  readClock,
  worldReadings,
} from './readClock.ts';

const c = 10;
const mesh = box([2, 1, 3]);
const thing = (motion: Motion, given: Partial<SceneObject> = {}) =>
  makeObject({ path: '/Thing', mesh, motion, ...given });
const clockOf = (motion: Motion, given: Partial<SceneObject> = {}): Clock =>
  objectClocks([thing(motion, given)], c)[0]!;
const at = (t: number, position: Vec3 = ZERO, u: Vec3 = ZERO) => ({ t, position, u });
const shown = (reading: ClockReading | ClockAbsence): ClockReading => {
  if (typeof reading === 'string') throw new Error(`the clock is ${reading}`);
  return reading;
};
const flying = (velocity: Vec3, position: Vec3 = ZERO): Motion => ({
  kind: 'uniform',
  pose: { ...IDENTITY_POSE, position },
  velocity,
});
const sampled: Motion = {
  kind: 'sampled',
  times: Float64Array.of(-9, -3, 1, 4),
  poses: Float64Array.from(
    [
      [-8, 2, -5],
      [20, 2, -5],
      [10, 8, -5],
      [0, 0, -9],
    ].flatMap((place) => [...place, ...IDENTITY]),
  ),
};
const accelerated: Motion = {
  kind: 'hyperbolic',
  pose: { ...IDENTITY_POSE, position: [10, 3, 1] },
  properAcceleration: [3, 1, -2],
  t0: -0.5,
};

describe('a clock', () => {
  it('at 0.5 c that passed here: D = √3 or 1/√3, and 1/γ = √3/2 in the slice', () => {
    const receding = readClock(clockOf(flying([5, 0, 0])), at(3), c);
    // 5t = 10 (3 − t).
    expect(shown(receding.seen).time).toBeCloseTo(2, 12);
    expect(shown(receding.seen).properTime).toBeCloseTo(Math.sqrt(3), 12);
    expect(shown(receding.seen).rate).toBeCloseTo(1 / Math.sqrt(3), 12);
    expect(shown(receding.slice)).toEqual(shown(receding.world));
    expect(shown(receding.slice).properTime).toBeCloseTo(1.5 * Math.sqrt(3), 12);
    expect(shown(receding.slice).rate).toBeCloseTo(Math.sqrt(3) / 2, 12);
    const coming = readClock(clockOf(flying([5, 0, 0])), at(-3), c);
    expect(shown(coming.seen).time).toBeCloseTo(-6, 12);
    expect(shown(coming.seen).rate).toBeCloseTo(Math.sqrt(3), 12);
  });

  it('at rest in the world is slow for one who flies, while the clocks that he passes run fast', () => {
    const u = properVelocity([0.8, 0, 0]);
    const observer = at(5, [40, 0, 0], u);
    const { seen, slice, world } = readClock(clockOf(restingAt(ZERO)), observer, c);
    expect(shown(seen)).toMatchObject({ time: 1, properTime: 1, rate: expect.closeTo(1 / 3, 12) });
    // t′ = γ(t − βx/c) = 3 s of his own, in which it takes 3 s/γ.
    expect(shown(slice).properTime).toBeCloseTo(1.8, 12);
    expect(shown(slice).rate).toBeCloseTo(0.6, 12);
    expect(shown(world)).toMatchObject({ time: 5, properTime: 5, rate: 1 });
    expect(shown(worldReadings(observer).seen).rate).toBeCloseTo(5 / 3, 12);
    expect(shown(ownReadings({ ...observer, properTime: 3 }).world)).toMatchObject({
      time: 5,
      properTime: 3,
      rate: expect.closeTo(0.6, 12),
    });
  });

  it.each<[string, Motion]>([
    ['flying', flying([6, -2, 1], [1, 5, -8])],
    ['between samples', sampled],
    ['accelerated', accelerated],
  ])('%s: its rates are the slopes of its readings by the own time of an observer who coasts', (_, motion) =>
    fc.assert(
      fc.property(properVelocityUpTo(5), uniform(-2, 0.8), (u, start) => {
        const clock = clockOf(motion);
        const h = 1e-5;
        const readAt = (tau: number) => readClock(clock, at(start + gamma(u) * tau, scale(u, c * tau), u), c);
        const [before, now, then] = [readAt(-h), readAt(0), readAt(h)];
        for (const way of ['seen', 'slice', 'world'] as const) {
          const [a, b, d] = [shown(before[way]), shown(now[way]), shown(then[way])];
          // Rates jump where samples meet.
          if (motion.kind === 'sampled' && motion.times.some((t) => t >= a.time && t <= d.time)) continue;
          const passed = way === 'world' ? d.time - a.time : 2 * h;
          expect((d.properTime - a.properTime) / passed / b.rate).toBeCloseTo(1, 4);
        }
      }),
    ),
  );

  it('in uniform motion takes 1/γ of the relative motion in the slice', () =>
    fc.assert(
      fc.property(properVelocityUpTo(50), properVelocityUpTo(50), uniform(0.1, 9), (own, other, tau) => {
        // Both pass the origin of spacetime; the ship's clock shows tau.
        const clock = clockOf(flying(scale(velocity(other), c)));
        const observer = at(gamma(own) * tau, scale(own, c * tau), own);
        const { properTime, rate } = shown(readClock(clock, observer, c).slice);
        const expected = 1 / (gamma(own) * gamma(other) - own[0] * other[0] - own[1] * other[1] - own[2] * other[2]);
        expect(rate / expected).toBeCloseTo(1, 7);
        expect(properTime / (tau * expected)).toBeCloseTo(1, 7);
      }),
    ));

  it('shows the same, seen and in the slice, in whatever frame the situation is described', () =>
    fc.assert(
      fc.property(
        properVelocityUpTo(5),
        properVelocityUpTo(5),
        properVelocityUpTo(5),
        fc.tuple(direction, magnitude(-1, 1.5)),
        uniform(-3, 3),
        (frame, own, other, [n, away], ct) => {
          const place = scale(n, away);
          // Born at a place of its line, so that its clock begins at the same event in all frames.
          const born = ([t, ...position]: FourVector, u: Vec3): Clock => ({
            path: '/Thing',
            carriers: [
              {
                line: {
                  kind: 'uniform',
                  position: addScaled(position, velocity(u), -t),
                  velocity: scale(velocity(u), c),
                },
                lifetime: { birth: t / c, death: Number.POSITIVE_INFINITY },
              },
            ],
          });
          const read = (X: FourVector, u: Vec3, clock: Clock): ClockReadings =>
            readClock(clock, at(X[0] / c, [X[1], X[2], X[3]], u), c);
          const birth: FourVector = [ct - 400, ...place];
          const here: FourVector = [0, 0, 0, 0];
          const before = read(here, own, born(birth, other));
          const [movedOwn, movedOther] = [relativeVelocity(own, frame), relativeVelocity(other, frame)];
          const after = read(boost(here, frame), movedOwn, born(boost(birth, frame), movedOther));
          for (const way of ['seen', 'slice'] as const) {
            const [a, b] = [before[way], after[way]];
            expect(typeof a).toBe(typeof b);
            if (typeof a === 'string' || typeof b === 'string') continue;
            expect(Math.abs(a.properTime - b.properTime)).toBeLessThan(1e-9 * (1 + Math.abs(a.properTime)));
            expect(a.rate / b.rate).toBeCloseTo(1, 9);
          }
        },
      ),
    ));

  it('shows nothing before birth, from death on, and behind a horizon', () => {
    const life = { birth: 1, death: 4 };
    const clock = clockOf(restingAt([20, 0, 0]), { lifetime: life });
    const states = (t: number) => {
      const { seen, slice, world } = readClock(clock, at(t), c);
      return [seen, slice, world].map((reading) => (typeof reading === 'string' ? reading : reading.properTime));
    };
    // Its light needs 2 s; its clock shows 0 at birth.
    expect(states(0.5)).toEqual(['unborn', 'unborn', 'unborn']);
    expect(states(2.5)).toEqual(['unborn', 1.5, 1.5]);
    expect(states(3.5)).toEqual([0.5, 2.5, 2.5]);
    expect(states(4)).toEqual([1, 'ended', 'ended']);
    expect(states(6)).toEqual(['ended', 'ended', 'ended']);
    // It comes from far away, and its first light, along the horizon ℓ = c²/a = 5 m behind it, is here at 2.5 s.
    const rocket = clockOf({ kind: 'hyperbolic', pose: IDENTITY_POSE, properAcceleration: [20, 0, 0], t0: 0 });
    expect(readClock(rocket, at(2.4, [-30, 0, 0]), c).seen).toBe('hidden');
    expect(readClock(rocket, at(2.6, [-30, 0, 0]), c).seen).toBeTypeOf('object');
  });

  it('is handed from piece to piece, and goes on', () => {
    const piece = (path: string, motion: Motion, birth: number, death: number) =>
      makeObject({ path, mesh, motion, pieceOf: '/Thing', lifetime: { birth, death } });
    const pieces = [
      piece('/Thing/piece2', flying([8, 0, 0], [-16, 0, 0]), 2, 7),
      piece('/Thing/piece1', restingAt(ZERO), Number.NEGATIVE_INFINITY, 2),
    ];
    const [clock, ...others] = objectClocks(pieces, c);
    expect(others).toEqual([]);
    expect(clock!.path).toBe('/Thing');
    expect([-3, 1, 2, 7].map((t) => clockTime(clock!, t, c))).toEqual([-3, 1, 2, expect.closeTo(2 + 5 * 0.6, 12)]);
    expect(shown(readClock(clock!, at(1.5), c).world).properTime).toBe(1.5);
    expect(shown(readClock(clock!, at(4.5), c).world).properTime).toBeCloseTo(3.5, 12);
    expect(readClock(clock!, at(7), c).world).toBe('ended');
  });
});

const conditions: FlightConditions = { c, lock: 'free', playing: true };
const start = (u: Vec3 = ZERO): FlightState =>
  flightOf({ t: 0, position: ZERO, u, orientation: IDENTITY, properTime: 0 });
const home = clockOf(restingAt(ZERO), { mesh: box([1, 1, 1]) });

/** Straight out and straight back at one rapidity, `tau` [s] of the own time each way. */
function twins(rapidity: number, tau: number): FlightPlayback {
  const n: Vec3 = [0, 0, -1];
  const out: FlightState = { ...start(), velocity: { direction: n, rapidity } };
  const there = flyArcs(out, [{ dTau: tau }], conditions);
  const back: FlightState = { ...there, velocity: { direction: negate(n), rapidity } };
  const arcs = [{ dTau: tau }];
  return new FlightPlayback({ legs: [out, back].map((first) => ({ conditions, start: first, arcs })) });
}

const readHome = (playback: FlightPlayback, tau: number) => {
  const observer = observerOf(playback.stateAt(tau));
  return { ...readClock(home, observer, c), own: observer.properTime };
};

describe('twins', () => {
  it('at rapidity 33 on both legs meet with clocks in the ratio cosh 33, to 1e-12', () => {
    const met = readHome(twins(33, 7), 14);
    expect(met.own).toBe(14);
    for (const way of ['seen', 'slice', 'world'] as const)
      expect(Math.abs(shown(met[way]).properTime / (14 * Math.cosh(33)) - 1)).toBeLessThan(1e-12);
  });

  it('see as many ticks as the other makes: D of the ways out and back are reciprocal, and their sum is the time at home', () =>
    fc.assert(
      fc.property(uniform(0.01, 6), uniform(0.5, 20), (rapidity, tau) => {
        const trip = twins(rapidity, tau);
        const out = shown(readHome(trip, 0.5 * tau).seen).rate;
        const back = shown(readHome(trip, 1.5 * tau).seen).rate;
        expect(out * back).toBeCloseTo(1, 9);
        expect(((out + back) * tau) / shown(readHome(trip, 2 * tau).world).properTime).toBeCloseTo(1, 9);
        // The turn does not change what is seen: the clock was slow before and is fast after.
        expect(shown(readHome(trip, tau).seen).properTime / (out * tau)).toBeCloseTo(1, 7);
      }),
    ));

  it('have in their slices a clock at home that jumps by 2 τ sinh φ tanh φ where they turn', () => {
    const [rapidity, tau] = [1.2, 5];
    const trip = twins(rapidity, tau);
    const [before, after] = [trip.stateAt(tau * (1 - 1e-12)), trip.stateAt(tau)].map(
      (state) => shown(readClock(home, observerOf(state), c).slice).properTime,
    );
    expect(after! - before!).toBeCloseTo(2 * tau * Math.sinh(rapidity) * Math.tanh(rapidity), 8);
  });
});

describe('a trip at one proper acceleration a', () => {
  const [a, d] = [4, 300];
  const rules = { c, acceleration: a, limit: 300 };
  const arcs = planTrip(start(), [0, d, 0], rules);
  const playback = new FlightPlayback({ legs: [{ conditions, start: start(), arcs }] });

  it('takes τ = (2c/a) acosh(1 + ad/2c²) by the ship and t = √((d/c)² + 4d/a) by the clocks at both ends', () => {
    const end = observerOf(playback.stateAt(playback.duration));
    const there = clockOf(restingAt([0, d, 0]), { mesh: box([1, 1, 1]) });
    const t = Math.sqrt((d / c) ** 2 + (4 * d) / a);
    expect(Math.abs(end.properTime / (((2 * c) / a) * Math.acosh(1 + (a * d) / (2 * c * c))) - 1)).toBeLessThan(1e-12);
    expect(Math.abs(shown(readClock(there, end, c).seen).properTime / t - 1)).toBeLessThan(1e-12);
    expect(Math.abs(shown(readClock(home, end, c).slice).properTime / t - 1)).toBeLessThan(1e-12);
    expect(Math.abs(shown(readClock(home, end, c).seen).properTime / (t - d / c) - 1)).toBeLessThan(1e-11);
  });

  it('shows of the clock at home (c/a)(1 − e^(−φ)) in its light and (c/a) tanh φ in the slice, both below c/a', () => {
    for (const part of [0.05, 0.3, 0.6, 0.999]) {
      const tau = (part * playback.duration) / 2;
      const phi = (a * tau) / c;
      const { seen, slice, world } = readClock(home, observerOf(playback.stateAt(tau)), c);
      expect(shown(seen).properTime).toBeCloseTo((c / a) * -Math.expm1(-phi), 11);
      expect(shown(seen).rate).toBeCloseTo(Math.exp(-phi), 12);
      expect(shown(slice).properTime).toBeCloseTo((c / a) * Math.tanh(phi), 11);
      expect(shown(world).properTime).toBeCloseTo((c / a) * Math.sinh(phi), 11);
    }
  });
});
