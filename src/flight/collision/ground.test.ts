import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AT_REST, FLIGHT_RULES, FREELY } from '../../../tests/support/flightFixtures.ts';
import { expectClose, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { planes } from '../../../tests/support/walls.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { normalize, type Vec3 } from '../../math/vec3.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import { relativeVelocity } from '../../physics/lorentz/velocity.ts';
import { flyArcs } from '../arc.ts';
import { boostOf, properVelocityOf } from '../boost.ts';
import { type FlightControls, type FlightRules, NO_CONTROLS } from '../controls.ts';
import { type FlightState, flightOf, observerOf } from '../flightState.ts';
import { driveMode } from '../modes/drive.ts';
import type { FlightMoment } from '../modes/flightMode.ts';
import { FlightPlayback } from '../recording/playback.ts';
import { FlightRecorder } from '../recording/recorder.ts';
import { arcsOf } from '../step.ts';
import { type FlownMoment, flyAmong } from './collide.ts';
import { comeDown, flyOnGround, withoutGround } from './ground.ts';
import type { Obstacles } from './obstacles.ts';

const { c } = FLIGHT_RULES;
const height = 1.7;
const UP: Vec3 = [0, 1, 0];
const FORWARD: Partial<FlightControls> = { thrust: [0, 0, -1] };
const freely = (moment: FlightMoment): FlownMoment => {
  const arcs = arcsOf(driveMode, moment);
  const after = flyArcs(moment.state, arcs, FREELY);
  return { pieces: [{ before: moment.state, arcs, after }], after };
};

interface Drive {
  readonly start: FlightState;
  readonly obstacles: Obstacles;
  readonly controls?: Partial<FlightControls>;
  readonly seconds: number;
  readonly rules?: Partial<FlightRules>;
  readonly recorder?: FlightRecorder;
  readonly fly?: (moment: FlightMoment) => FlownMoment;
  readonly seen?: (state: FlightState) => void;
}

function drive({ obstacles, fly = freely, ...given }: Drive): FlightState {
  let state = given.start;
  for (let i = 0; i < given.seconds * 60; i++) {
    const controls = { ...NO_CONTROLS, ...given.controls };
    const moment = { state, controls, dt: 1 / 60, rules: { ...FLIGHT_RULES, ...given.rules } };
    const flown = flyOnGround(moment, FREELY, { obstacles, height }, fly);
    for (const piece of flown.pieces) given.recorder?.add(piece.before, piece.arcs, FREELY, piece.after);
    state = flown.after;
    given.seen?.(state);
  }
  return state;
}

/** Ground at rest of that height [m] at each z [m], asked for straight down. */
const terrain = (heightAt: (z: number) => number, slopeAt: (z: number) => number): Obstacles => ({
  first({ start: { t, x }, dx }, end) {
    const y = heightAt(x[2]);
    if (x[1] < y || x[1] + end * dx[1] > y) return undefined;
    return {
      event: { t, x: [x[0], y, x[2]] },
      velocity: boostOf([0, 0, 0]),
      normal: normalize([0, 1, -slopeAt(x[2])]),
    };
  },
});
const at = (x: number, y: number, z: number, u: Vec3 = [0, 0, 0]): FlightState =>
  flightOf({ ...AT_REST, position: [x, y, z], u });
const place = (state: FlightState): Vec3 => observerOf(state).position;

describe('on an inclined plane', () => {
  const maxSpeed = 0.8;
  it('the height above it is kept exactly, and along it one is as fast as on the level', () =>
    fc.assert(
      fc.property(uniform(-0.75, 0.75), uniform(-3, 3), (slope, heading) => {
        const plane = (rise: number) => planes([{ at: [0, 0, 0], normal: [0, 1, rise], beta: 0 }], c);
        const start = flightOf({ ...AT_REST, position: [0, height, 0], orientation: fromAxisAngle(UP, heading) });
        const options = { start, controls: { ...FORWARD, fullSpeed: true }, seconds: 3, rules: { maxSpeed } };
        const level: number[] = [];
        drive({ ...options, obstacles: plane(0), seen: (state) => level.push(state.velocity.rapidity) });
        const inclined: number[] = [];
        drive({
          ...options,
          obstacles: plane(slope),
          seen: (state) => {
            const [, y, z] = place(state);
            expectClose(y + slope * z, height, 1e-9 * (1 + Math.abs(z)));
            // A motion in the plane: its normal is (0, 1, slope).
            const beta = velocity(observerOf(state).u);
            expectClose(beta[1] + slope * beta[2], 0, 1e-9);
            expect(Math.hypot(...beta)).toBeLessThan(1);
            inclined.push(state.velocity.rapidity);
          },
        });
        expectClose(inclined, level, 1e-9);
        expectClose(inclined.at(-1)!, Math.atanh(maxSpeed), 1e-9);
      }),
      { numRuns: 8 },
    ));
});

describe('where the ground bends', () => {
  const cruise = { cruise: true };

  it('a motion keeps its rapidity, and follows hills', () => {
    const heightAt = (z: number): number => 2 * Math.sin(z / 5);
    let lowest = Number.POSITIVE_INFINITY;
    let highest = Number.NEGATIVE_INFINITY;
    const end = drive({
      start: at(0, height, 0, [0, 0, -0.5]),
      obstacles: terrain(heightAt, (z) => 0.4 * Math.cos(z / 5)),
      seconds: 8,
      rules: cruise,
      seen: (state) => {
        const [, y, z] = place(state);
        expectClose(state.velocity.rapidity, Math.asinh(0.5), 1e-9);
        expect(Math.abs(y - heightAt(z) - height)).toBeLessThan(1e-4);
        lowest = Math.min(lowest, y);
        highest = Math.max(highest, y);
      },
    });
    expect(place(end)[2]).toBeLessThan(-30);
    expect(highest - lowest).toBeGreaterThan(3.5);
  });

  it('small steps are climbed, up and down, no steeper than 45°; a recording knows the way', () => {
    // Five steps of 0.2 m up, and down again at once from 1 m to 0.7 m.
    const heightAt = (z: number): number => (z > -2 ? 0 : z > -12 ? 0.2 * Math.min(5, Math.floor(-z / 2)) : 0.7);
    const recorder = new FlightRecorder();
    let before = place(at(0, height, 0));
    const end = drive({
      start: at(0, height, 0, [0, 0, -0.1]),
      obstacles: terrain(heightAt, () => 0),
      seconds: 16,
      rules: cruise,
      recorder,
      seen: (state) => {
        const now = place(state);
        expect(Math.abs(now[1] - before[1])).toBeLessThanOrEqual(Math.abs(now[2] - before[2]) * (1 + 1e-6));
        before = now;
      },
    });
    expect(place(end)[2]).toBeLessThan(-13);
    expectClose(place(end)[1], height + 0.7, 1e-5);
    expectClose(end.velocity.rapidity, Math.asinh(0.1), 1e-9);
    const playback = new FlightPlayback(recorder.recording());
    expectClose(place(playback.stateAt(playback.duration)), place(end), 1e-9);
  });

  it('nobody falls: over a deep ditch, a high step and a steep slope the height stays', () => {
    for (const obstacles of [
      terrain(
        (z) => (z < -2 && z > -6 ? -3 : 0),
        () => 0,
      ),
      terrain(
        (z) => (z < -2 && z > -6 ? 1 : 0),
        () => 0,
      ),
      terrain(
        (z) => (z < -2 && z > -6 ? 0.1 : 0),
        (z) => (z < -2 && z > -6 ? 1.2 : 0),
      ),
      planes([], c),
    ]) {
      const end = drive({
        start: at(0, height, 0, [0, 0, -0.3]),
        obstacles,
        seconds: 3,
        rules: cruise,
        seen: (state) => expectClose(place(state)[1], height, 1e-6),
      });
      expectClose(place(end), [0, height, -0.3 * c * 3], 1e-6);
    }
  });
});

describe('coming down', () => {
  const down = (obstacles: Obstacles) => comeDown(at(3, 300, -4, [0.2, 0, 0.1]), { obstacles, height }, UP, FREELY);
  const plane = (normal: Vec3, beta = 0): Obstacles => planes([{ at: [0, 0, 0], normal, beta }], c);

  it('ends at rest, at the height of the eye above what is straight below', () => {
    // y = z/2 there.
    expectClose(down(plane([0, 2, -1]))!.position, [3, -2 + height, -4], 1e-9);
    expectClose(down(plane([0, 2, -1]))!.u, [0, 0, 0], 0);
  });

  it('on what rises at 0.6 c ends at that height of its own frame, and is carried along', () => {
    const { position, u } = down(plane([0, 1, 0], 0.6))!;
    expectClose(position, [3, height * 0.8, -4], 1e-9);
    expectClose(u, [0, 0.75, 0], 1e-12);
    const start = flightOf({ ...AT_REST, position, u });
    const end = drive({ start, obstacles: plane([0, 1, 0], 0.6), seconds: 2 });
    const { t, position: after } = observerOf(end);
    expectClose(after[1] - 0.6 * c * t, height * 0.8, 1e-6);
  });

  it('is not possible over nothing, over a steep slope, and below the ground', () => {
    expect(down(planes([], c))).toBeUndefined();
    expect(down(plane([0, 1, -1.2]))).toBeUndefined();
    expect(comeDown(at(0, -1, 0), { obstacles: plane([0, 1, 0]), height }, UP, FREELY)).toBeUndefined();
  });
});

describe('where the ground moves', () => {
  it('one comes to rest on it, and is carried along', () => {
    const obstacles = terrain(
      () => 0,
      () => 0,
    );
    const beta: Vec3 = [0.6, 0, 0];
    const belt: Obstacles = {
      first: (segment, end) => {
        const met = obstacles.first(segment, end);
        return met && { ...met, velocity: boostOf([0.75, 0, 0]) };
      },
    };
    const end = drive({ start: at(0, height, 0), obstacles: belt, seconds: 6 });
    expectClose(velocity(observerOf(end).u), beta, 1e-12);
    expectClose(place(end)[1], height, 1e-12);
    // There the keys move one as they do at rest.
    const walking = drive({ start: end, obstacles: belt, controls: FORWARD, seconds: 2 });
    const own = relativeVelocity(properVelocityOf(walking.velocity), [0.75, 0, 0]);
    expectClose(Math.hypot(...own) / Math.hypot(1, ...own), FLIGHT_RULES.maxSpeed / 2, 1e-9);
  });

  it('in a lift the height is that of its frame, γ times that of the world', () => {
    const beta = 0.6;
    const obstacles = planes([{ at: [0, 0, 0], normal: UP, beta }], c);
    const end = drive({ start: at(0, height / 1.25, 0, [0, 0.75, 0]), obstacles, controls: FORWARD, seconds: 3 });
    const { t, position, u } = observerOf(end);
    expectClose((position[1] - beta * c * t) * 1.25, height, 1e-9 * position[1]);
    expect(relativeVelocity(u, [0, 0.75, 0])[2]).toBeLessThan(-0.1);
  });
});

it('what is climbed is no wall, and what is steep is one', () => {
  const slope = (rise: number): Obstacles => planes([{ at: [0, 0, -10], normal: [0, 1, rise], beta: 0 }], c);
  const rules = (obstacles: Obstacles) =>
    ({ obstacles: withoutGround(obstacles, UP), kind: 'stop', radius: 0.3 }) as const;
  const driven = (obstacles: Obstacles): FlightState =>
    drive({
      start: at(0, height, 0, [0, 0, -0.4]),
      obstacles,
      seconds: 4,
      rules: { cruise: true },
      fly: (moment) => flyAmong(driveMode, moment, FREELY, rules(obstacles)),
    });
  expect(driven(slope(0.9)).velocity.rapidity).toBeGreaterThan(0.1);
  expect(driven(slope(4)).velocity.rapidity).toBe(0);
});
