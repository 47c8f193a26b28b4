import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AT_REST, FLIGHT_RULES, FREELY } from '../../../tests/support/flightFixtures.ts';
import { direction, expectClose, properVelocityUpTo, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, rotate } from '../../math/quat.ts';
import { scale, type Vec3 } from '../../math/vec3.ts';
import { type FlightArc, type FlightConditions, flyArcs } from '../arc.ts';
import { NO_CONTROLS } from '../controls.ts';
import { type FlightState, flightOf, observerOf } from '../flightState.ts';
import { FLIGHT_MODES } from '../modes/modes.ts';
import { arcsOf } from '../step.ts';
import { cutFlight, spliceFlights } from './edit.ts';
import { filmClock } from './filmClock.ts';
import { FlightPlayback } from './playback.ts';
import { FlightRecorder } from './recorder.ts';
import { type FlightRecording, recordingDuration } from './recording.ts';

const [conditions, rules] = [FREELY, FLIGHT_RULES];
const rest = flightOf({ ...AT_REST, t: 1, position: [1, 2, 3] });

interface Flown {
  readonly recording: FlightRecording;
  /** What the pilot saw, by the pilot's time. */
  readonly seen: readonly { readonly time: number; readonly state: FlightState }[];
}

/** Flies with controls that change, in frames of uneven length, and is put elsewhere once. */
function flown(seed: number, frames = 400): Flown {
  const recorder = new FlightRecorder();
  const seen = [];
  let [state, time] = [rest, 0];
  for (let i = 0; i < frames; i++) {
    if (i === frames / 2) state = flightOf({ ...observerOf(state), position: [9, 9, 9], t: 2 + observerOf(state).t });
    const dt = 0.01 + 0.008 * Math.sin(seed + i);
    const thrust: Vec3 = i % 90 < 50 ? [Math.round(Math.sin(i / 20 + seed)), 0, -1] : [0, 0, 0];
    const turn: Vec3 = i % 60 < 30 ? [0.01, 0.02, 0.005] : [0, 0, 0];
    const moment = { state, controls: { ...NO_CONTROLS, thrust, turn, brake: i % 100 > 90 }, dt, rules };
    const arcs = arcsOf(FLIGHT_MODES.thrust, moment);
    const after = flyArcs(state, arcs, conditions);
    recorder.add(state, arcs, conditions, after);
    [state, time] = [after, time + dt];
    seen.push({ time, state });
  }
  return { recording: recorder.recording(), seen };
}

function expectSame(a: FlightState, b: FlightState): void {
  const [one, other] = [observerOf(a), observerOf(b)];
  expectClose([one.t, ...one.position, ...one.u], [other.t, ...other.position, ...other.u], 1e-11);
  expectClose(rotate(one.orientation, [1, 2, 3]), rotate(other.orientation, [1, 2, 3]), 1e-11);
  expectClose(one.properTime, other.properTime, 1e-11);
}

describe('a recorded flight', () => {
  it('is played back as it was seen, frame by frame', () =>
    fc.assert(
      fc.property(uniform(0, 6), (seed) => {
        const { recording, seen } = flown(seed);
        expect(recording.legs).toHaveLength(2);
        const playback = new FlightPlayback(recording);
        expectClose(playback.duration, seen.at(-1)!.time, 1e-12);
        // The frame before the jump has its time in common with the first moment after it.
        for (const [i, { time, state }] of seen.entries())
          if (i !== 199) expectSame(playback.stateAt(Math.min(time, playback.duration)), state);
      }),
      { numRuns: 10 },
    ));

  it('keeps a long push and a long rest as one arc each', () => {
    const recorder = new FlightRecorder();
    let state = rest;
    for (let i = 0; i < 200; i++) {
      const push = { direction: [0, 0, -1] as Vec3, size: 3 };
      const arcs: FlightArc[] = [i < 100 ? { dTau: 0.01, push } : { dTau: 0.01 }];
      const after = flyArcs(state, arcs, conditions);
      recorder.add(state, arcs, conditions, after);
      state = after;
    }
    const [leg, ...others] = recorder.recording().legs;
    expect(others).toEqual([]);
    expect(leg!.arcs.map(({ push }) => push?.size)).toEqual([3, undefined]);
    expectSame(new FlightPlayback({ legs: [leg!] }).stateAt(2), state);
  });

  it('turns evenly between the moments of the pilot', () => {
    const arcs: FlightArc[] = [{ dTau: 1, orientation: fromAxisAngle([0, 1, 0], 0.4) }];
    const playback = new FlightPlayback({ legs: [{ conditions, start: rest, arcs }] });
    expectClose(rotate(playback.stateAt(0.25).orientation, [1, 0, 0]), [Math.cos(0.1), 0, -Math.sin(0.1)], 1e-14);
  });

  it('knows when a world time was: of a hyperbola, t = c/a sinh(aτ/c)', () =>
    fc.assert(
      fc.property(uniform(0, 1), direction, (share, n) => {
        const arcs: FlightArc[] = [{ dTau: 6, push: { direction: n, size: 5 } }, { dTau: 1 }];
        const playback = new FlightPlayback({ legs: [{ conditions, start: rest, arcs }] });
        const tau = 6 * share;
        expectClose(playback.timeAtWorld(1 + 2 * Math.sinh(tau / 2)), tau, 1e-12);
        expectClose(filmClock(playback, 'world')!.pilotTime(2 * Math.sinh(tau / 2)), tau, 1e-12);
        expectClose(filmClock(playback, 'world')!.duration, 2 * Math.sinh(3) + Math.cosh(3), 1e-12);
        expect(filmClock(playback, 'proper')!.pilotTime(tau)).toBe(tau);
        expect(playback.worldSpan()![0]).toBe(1);
        expectClose(playback.worldSpan()![1], 1 + 2 * Math.sinh(3) + Math.cosh(3), 1e-12);
      }),
    ));

  it('has no world time where that stands still or goes back', () => {
    const arcs: FlightArc[] = [{ dTau: 1 }];
    const leg = { conditions, start: rest, arcs };
    const early = flightOf({ ...observerOf(rest), t: 0 });
    const back = new FlightPlayback({ legs: [leg, { ...leg, start: early }] });
    expect(back.worldSpan()).toBeUndefined();
    expect(filmClock(back, 'world')).toBeUndefined();
    expect(filmClock(back, 'proper')!.duration).toBe(2);
    const paused = { ...leg, conditions: { ...conditions, playing: false } };
    expect(new FlightPlayback({ legs: [paused] }).worldSpan()).toBeUndefined();
    const later = flightOf({ ...observerOf(rest), t: 5 });
    expect(new FlightPlayback({ legs: [leg, { ...leg, start: later }] }).worldSpan()).toEqual([1, 6]);
  });
});

describe('editing', () => {
  it('cuts a part that is flown as the whole is', () =>
    fc.assert(
      fc.property(uniform(0, 6), uniform(0, 1), uniform(0, 1), uniform(0, 1), (seed, a, b, at) => {
        const { recording } = flown(seed, 100);
        const whole = new FlightPlayback(recording);
        const [from, to] = [Math.min(a, b) * whole.duration, Math.max(a, b) * whole.duration];
        fc.pre(to - from > 1e-6);
        const part = new FlightPlayback(cutFlight(recording, from, to));
        expectClose(part.duration, to - from, 1e-12);
        const time = at * part.duration;
        const [mine, theirs] = [observerOf(part.stateAt(time)), observerOf(whole.stateAt(from + time))];
        expectClose([mine.t, ...mine.position, ...mine.u], [theirs.t, ...theirs.position, ...theirs.u], 1e-10);
      }),
      { numRuns: 30 },
    ));

  it('joins flights, and a flight that was cut', () => {
    const { recording } = flown(1);
    const duration = recordingDuration(recording);
    const joined = spliceFlights([cutFlight(recording, 0, 1.5), cutFlight(recording, 1.5, duration)]);
    expectClose(recordingDuration(joined), duration, 1e-12);
    const [a, b] = [new FlightPlayback(joined), new FlightPlayback(recording)];
    for (const time of [0, 1, 1.5, 2.2, duration]) {
      const [mine, theirs] = [observerOf(a.stateAt(time)), observerOf(b.stateAt(time))];
      expectClose([...mine.position, ...mine.u], [...theirs.position, ...theirs.u], 1e-10);
    }
  });
});

it('with the lock fly, pictures that were joined to one burn lead as far as they did apart', () => {
  const recorder = new FlightRecorder();
  const held: FlightConditions = { c: 10, lock: 'fly', playing: true };
  const burn: FlightArc = { dTau: 1 / 60, push: { direction: [0, 0, -1], size: 5 } };
  let state = flightOf({ ...observerOf(rest), u: [0, 0, 0] });
  const start = observerOf(state).position[2];
  for (let i = 0; i < 120; i++) {
    const after = flyArcs(state, [burn], held);
    recorder.add(state, [burn], held, after);
    state = after;
  }
  const recording = recorder.recording();
  expect(recording.legs[0]?.arcs).toHaveLength(1);
  // (c²/a) ln cosh(aτ/c), with τ = 2 s.
  const end = start - 20 * Math.log(Math.cosh(1));
  expectClose(observerOf(new FlightPlayback(recording).stateAt(2)).position[2], end, 1e-12);
  expectClose(observerOf(state).position[2], end, 1e-12);
});

it('is the same in other conditions: a velocity in place, and a world that stands still', () => {
  fc.assert(
    fc.property(properVelocityUpTo(2), (u) => {
      const arcs: FlightArc[] = [{ dTau: 0.5 }, { dTau: 0.25, push: { direction: [1, 0, 0], size: 1 } }];
      const start = flightOf({ ...observerOf(rest), u });
      for (const other of [
        { c: 10, lock: 'look', playing: true },
        { c: 10, lock: 'fly', playing: false },
      ] as const) {
        const playback = new FlightPlayback({ legs: [{ conditions: other, start, arcs }] });
        expectSame(playback.stateAt(0.75), flyArcs(start, arcs, other));
        if (other.lock === 'look') expectClose(observerOf(playback.stateAt(0.6)).position, scale([1, 2, 3], 1), 0);
        else expect(observerOf(playback.stateAt(0.6)).t).toBe(1);
      }
    }),
  );
});
