import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AT_REST, FLIGHT_RULES, FREELY } from '../../../tests/support/flightFixtures.ts';
import { direction, expectClose, magnitude, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { planes } from '../../../tests/support/walls.ts';
import { addScaled, dot, scale, type Vec3 } from '../../math/vec3.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import type { FlightConditions } from '../arc.ts';
import { boostOf, properVelocityOf, relativeBoost } from '../boost.ts';
import { type FlightControls, NO_CONTROLS } from '../controls.ts';
import { type FlightState, flightOf, observerOf } from '../flightState.ts';
import { FLIGHT_MODES, type FlightModeName } from '../modes/modes.ts';
import { FlightPlayback } from '../recording/playback.ts';
import { FlightRecorder } from '../recording/recorder.ts';
import { type CollisionKind, type Contact, flyAmong } from './collide.ts';
import type { Obstacles } from './obstacles.ts';

const { c, along: a } = FLIGHT_RULES;
const radius = 0.25;
const FORWARD: Partial<FlightControls> = { thrust: [0, 0, -1], fullSpeed: true };

interface Flight {
  readonly mode?: FlightModeName;
  readonly start?: FlightState;
  readonly obstacles: Obstacles;
  readonly kind?: CollisionKind;
  readonly controls?: Partial<FlightControls>;
  readonly seconds: number;
  readonly conditions?: FlightConditions;
  readonly recorder?: FlightRecorder;
  readonly seen?: (state: FlightState, contact: Contact | undefined) => void;
}

function fly({ mode = 'thrust', kind = 'stop', conditions = FREELY, ...flight }: Flight): FlightState {
  const dt = 1 / 60;
  let state = flight.start ?? flightOf(AT_REST);
  for (let i = 0; i < flight.seconds * 60; i++) {
    const controls = { ...NO_CONTROLS, ...flight.controls };
    const moment = { state, controls, dt, rules: FLIGHT_RULES };
    const { obstacles } = flight;
    const flown = flyAmong(FLIGHT_MODES[mode], moment, conditions, { obstacles, kind, radius });
    for (const piece of flown.pieces) flight.recorder?.add(piece.before, piece.arcs, conditions, piece.after);
    state = flown.after;
    flight.seen?.(state, flown.contact);
  }
  return state;
}

const wallAt = (distance: number): Obstacles => planes([{ at: [0, 0, -distance], normal: [0, 0, 1], beta: 0 }], c);
const moving = (u: Vec3): FlightState => flightOf({ ...AT_REST, u });

describe('stop', () => {
  it('begins to brake (γ − 1)c²/a before, and is at rest at the clearance', () =>
    fc.assert(
      fc.property(uniform(0.05, 3), uniform(0.1, 15), (rapidity, more) => {
        const gap = ((Math.cosh(rapidity) - 1) * c * c) / a + more;
        let begun: number | undefined;
        const end = fly({
          start: moving([0, 0, -Math.sinh(rapidity)]),
          obstacles: wallAt(gap + radius),
          seconds: 60,
          seen: (state, contact) => {
            // In the moment in which the brake begins.
            if (contact === 'braking') begun ??= -observerOf(state).position[2];
          },
        });
        expectClose(-observerOf(end).position[2], gap, 1e-9 * gap);
        expect(end.velocity.rapidity).toBe(0);
        const moment = (c * Math.sinh(rapidity)) / 60;
        expect(begun!).toBeGreaterThan(more - 1e-9);
        expect(begun!).toBeLessThan(more + moment * (1 + 1e-9));
      }),
      { numRuns: 30 },
    ));

  it('who accelerates all the time stops there too, in every mode', () => {
    for (const mode of ['velocity', 'drive', 'thrust', 'vehicle'] as const) {
      const contacts = new Set<Contact | undefined>();
      const end = fly({
        mode,
        obstacles: wallAt(20),
        controls: FORWARD,
        seconds: 15,
        seen: (_, met) => contacts.add(met),
      });
      expectClose(-observerOf(end).position[2], 20 - radius, 1e-9 * 20);
      expect(end.velocity.rapidity).toBe(0);
      expect([...contacts]).toContain('braking');
      expect([...contacts]).not.toContain('too-fast');
    }
  });

  it('who is too fast says so, brakes as well, and is stopped at once: a jump, which a recording keeps as another leg', () => {
    const recorder = new FlightRecorder();
    const contacts: (Contact | undefined)[] = [];
    const [rapidity, gap] = [2, 10];
    const end = fly({
      start: moving([0, 0, -Math.sinh(rapidity)]),
      obstacles: wallAt(gap + radius),
      seconds: 1,
      recorder,
      seen: (_, contact) => contacts.push(contact),
    });
    expect(contacts[0]).toBe('too-fast');
    expect(contacts.at(-1)).toBeUndefined();
    expect(end.velocity.rapidity).toBe(0);
    expectClose(-observerOf(end).position[2], gap, 1e-9);
    const recording = recorder.recording();
    expect(recording.legs).toHaveLength(2);
    // Braked all the way: cosh φ falls by ad/c².
    const crash = new FlightPlayback({ legs: recording.legs.slice(0, 1) });
    const impact = crash.stateAt(crash.duration);
    expectClose(Math.cosh(impact.velocity.rapidity), Math.cosh(rapidity) - (a * gap) / c ** 2, 1e-9);
    const whole = new FlightPlayback(recording);
    expect(whole.duration).toBeCloseTo(1, 12);
    const last = observerOf(whole.stateAt(whole.duration));
    expectClose([last.t, ...last.position, ...last.u], [observerOf(end).t, 0, 0, -gap, 0, 0, 0], 1e-9);
  });

  it('at a wall that comes nearer one is carried along, at its clearance in the frame where it rests', () => {
    const beta = 0.6;
    const obstacles = planes([{ at: [0, 0, -5], normal: [0, 0, 1], beta }], c);
    const end = observerOf(fly({ mode: 'thrust', obstacles, seconds: 2 }));
    expectClose(velocity(end.u), [0, 0, beta], 1e-12);
    // γ (z − z_wall) at one moment of the world.
    expectClose((end.position[2] - (-5 + beta * c * end.t)) * 1.25, radius, 1e-9);
  });

  it('in a frozen instant a moving wall is at rest, and contracted', () => {
    const obstacles = planes([{ at: [0, 0, -5], normal: [0, 0, 1], beta: -0.6 }], c);
    const conditions: FlightConditions = { ...FREELY, playing: false };
    const end = observerOf(fly({ mode: 'velocity', obstacles, seconds: 4, controls: FORWARD, conditions }));
    expect(end.t).toBe(0);
    expectClose(end.position[2], -5 + radius, 1e-8);
  });

  it('leaves alone who flies away, or is held in place', () => {
    const away = { mode: 'thrust', seconds: 1, start: moving([0, 0, 1]) } as const;
    const free = planes([], c);
    expect(fly({ ...away, obstacles: wallAt(radius) })).toEqual(fly({ ...away, obstacles: free }));
    const held = { ...FREELY, lock: 'look' } as const;
    const look = { ...away, conditions: held, controls: FORWARD };
    expect(fly({ ...look, obstacles: wallAt(1) })).toEqual(fly({ ...look, obstacles: free }));
  });
});

describe('with the lock fly', () => {
  it('one brakes too, from (c²/a) ln cosh φ before, and is not stopped at once', () => {
    const [rapidity, more] = [1.5, 6];
    const gap = ((c * c) / a) * Math.log(Math.cosh(rapidity)) + more;
    const recorder = new FlightRecorder();
    let begun: number | undefined;
    const end = fly({
      start: moving([0, 0, -Math.sinh(rapidity)]),
      obstacles: wallAt(gap + radius),
      seconds: 12,
      conditions: { ...FREELY, lock: 'fly' },
      recorder,
      seen: (state, contact) => {
        if (contact === 'braking') begun ??= -observerOf(state).position[2];
      },
    });
    expectClose(-observerOf(end).position[2], gap, 1e-9 * gap);
    expect(end.velocity.rapidity).toBe(0);
    expect(recorder.recording().legs).toHaveLength(1);
    expect(begun!).toBeGreaterThan(more - 1e-9);
    expect(begun!).toBeLessThan(more + (c * Math.tanh(rapidity)) / 60 + 1e-9);
  });
});

describe('slide', () => {
  it('begins to brake (c²/a) tanh(δ/2) γβ_⊥ before, keeps the speed along the wall all the time, and is not stopped at once', () =>
    fc.assert(
      fc.property(uniform(-2, 2), uniform(0.3, 1.5), uniform(0.1, 5), fc.boolean(), (along, into, more, isHeld) => {
        const u: Vec3 = [along, 0, -into];
        const beta = velocity(u);
        // cosh δ = γ₀/γ₁, since the speed along the wall is the same.
        const gammas = [1 / Math.sqrt(1 - dot(beta, beta)), 1 / Math.sqrt(1 - beta[0] ** 2)] as const;
        const delta = Math.acosh(gammas[0] / gammas[1]);
        const way = isHeld ? Math.log(Math.cosh(delta)) / gammas[1] : Math.tanh(delta / 2) * into;
        const gap = ((c * c) / a) * way + more;
        const recorder = new FlightRecorder();
        let begun: number | undefined;
        const end = fly({
          start: moving(u),
          obstacles: wallAt(gap + radius),
          kind: 'slide',
          seconds: 10,
          conditions: isHeld ? { ...FREELY, lock: 'fly' } : FREELY,
          recorder,
          seen: (state, contact) => {
            expectClose(velocity(observerOf(state).u)[0], beta[0], 1e-9);
            if (contact === 'braking') begun ??= -observerOf(state).position[2];
          },
        });
        expectClose(-observerOf(end).position[2], gap, 1e-8 * gap);
        expectClose(velocity(observerOf(end).u), [beta[0], 0, 0], 1e-7);
        // What is left where the distance is rounding: √(2as)/c, which is 1e-8 for s = 1e-15 m.
        const { legs } = recorder.recording();
        expect(legs.length).toBeLessThanOrEqual(2);
        const first = new FlightPlayback({ legs: legs.slice(0, 1) });
        const left = relativeBoost(first.stateAt(first.duration).velocity, end.velocity);
        expect(left.rapidity).toBeLessThan(1e-7);
        expect(begun!).toBeGreaterThan(more - 1e-9);
        expect(begun!).toBeLessThan(more + (c * into) / 60 + 1e-9);
      }),
      { numRuns: 8 },
    ));

  it('goes on along a wall at the speed that it had along it, and stays at the clearance', () => {
    const u: Vec3 = [0.6, 0, -0.8];
    const end = observerOf(fly({ start: moving(u), obstacles: wallAt(3), kind: 'slide', seconds: 3 }));
    expectClose(velocity(end.u), [velocity(u)[0], 0, 0], 1e-12);
    expectClose(end.position[2], -3 + radius, 1e-8);
    expectClose(end.position[0], velocity(u)[0] * c * end.t, 1e-9 * end.position[0]);
  });

  it('pressed against a wall one glides along it in one leg of a recording', () => {
    const recorder = new FlightRecorder();
    const start = flightOf({ ...AT_REST, position: [0, 0, 0], u: [1, 0, 0] });
    const controls = { thrust: [0, 0, -1] as Vec3, fullSpeed: true };
    const end = observerOf(fly({ start, obstacles: wallAt(radius), kind: 'slide', controls, seconds: 3, recorder }));
    expectClose(end.position[2], 0, 1e-7);
    expectClose(end.u, [1, 0, 0], 1e-7);
    expect(recorder.recording().legs).toHaveLength(1);
  });

  it('stays within a room, wherever one flies', () =>
    fc.assert(
      fc.property(direction, magnitude(-1, 0.5), direction, (n, size, thrust) => {
        const half = 4;
        const axes: readonly Vec3[] = [
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, 1],
        ];
        const room = axes.flatMap((normal) => [-half, half].map((s) => ({ at: scale(normal, s), normal, beta: 0 })));
        fly({
          start: moving(scale(n, size)),
          obstacles: planes(room, c),
          kind: 'slide',
          controls: { thrust },
          seconds: 3,
          seen: (state) => {
            const { position } = observerOf(state);
            for (const axis of axes) expect(Math.abs(dot(position, axis))).toBeLessThan(half);
          },
        });
      }),
      { numRuns: 40 },
    ));

  it('is the same in the frame of the wall', () =>
    fc.assert(
      fc.property(uniform(-0.8, 0.8), direction, uniform(0.1, 1), (beta, n, size) => {
        // Towards the wall, which moves with ±β along its normal z.
        const own = scale([n[0], n[1], -Math.abs(n[2]) - 0.2], size);
        const wall = boostOf([0, 0, beta / Math.sqrt(1 - beta * beta)]);
        const rest = planes([{ at: [0, 0, -2], normal: [0, 0, 1], beta: 0 }], c);
        const there = fly({ start: moving(own), obstacles: rest, kind: 'slide', seconds: 5 });
        // The same seen from the world: at t = 0 both are at the origin's event, and the wall is contracted.
        const gamma = 1 / Math.sqrt(1 - beta * beta);
        const u: Vec3 = addScaled(own, [0, 0, 1], gamma * (own[2] + beta * Math.hypot(1, ...own)) - own[2]);
        const obstacles = planes([{ at: [0, 0, -2 / gamma], normal: [0, 0, 1], beta }], c);
        const here = fly({ start: moving(u), obstacles, kind: 'slide', seconds: 5 });
        const seen = relativeBoost(here.velocity, wall);
        expectClose(properVelocityOf(seen), properVelocityOf(there.velocity), 1e-9);
      }),
      { numRuns: 40 },
    ));
});
