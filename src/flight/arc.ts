import { normalizeQuat, type Quat } from '../math/quat.ts';
import { plus } from '../math/sum.ts';
import { scale, type Vec3, ZERO } from '../math/vec3.ts';
import { type Boost, relativeBoost } from './boost.ts';
import {
  accelerateFlight,
  coastFlight,
  type FlightState,
  type ProperAcceleration,
  shifted,
  wayAtSpeed,
} from './flightState.ts';

/**
 * `free`: the observer flies. `look`: has a velocity but stays in place, to see the effect of speed at one point.
 * `fly`: moves, while the picture is that of an observer at rest.
 */
export type Lock = 'free' | 'look' | 'fly';
export const LOCKS: readonly Lock[] = ['free', 'look', 'fly'];

/** The proper velocity γβ with which one sees, where one has `u`: with the lock `fly` the picture is that of one at rest. */
export const seenVelocity = (lock: Lock, u: Vec3): Vec3 => (lock === 'fly' ? ZERO : u);

/** A piece of a flight with one constant proper acceleration. */
export interface FlightArc {
  /** Proper time that it takes [s]. */
  readonly dTau: number;
  /** To which the ship turns at its beginning; absent: the axes are gyroscopes. */
  readonly orientation?: Quat;
  /** Absent: it coasts. */
  readonly push?: ProperAcceleration;
  /** The velocity at its end, where the push reaches it exactly. */
  readonly reached?: Boost;
}

/** How arcs are flown. */
export interface FlightConditions {
  /** [m/s] */
  readonly c: number;
  readonly lock: Lock;
  /** Whether world time runs: otherwise one moves through a frozen instant. */
  readonly playing: boolean;
}

/** The state after `dTau` [s] of an arc, by default after all of it. */
export function flyArc(
  before: FlightState,
  arc: FlightArc,
  conditions: FlightConditions,
  dTau = arc.dTau,
): FlightState {
  const state = arc.orientation ? { ...before, orientation: arc.orientation } : before;
  const moved = freely(state, arc, conditions.c, dTau);
  const { c, lock, playing } = conditions;
  if (lock === 'free') return playing ? moved : { ...moved, t: state.t, properTime: state.properTime };
  // With a lock, world time runs as the pilot's: `look` stays in place, and `fly` is at rest for the picture.
  const own = lock === 'look' ? dTau / Math.cosh(moved.velocity.rapidity) : dTau;
  const clocks = playing
    ? { t: plus(state.t, dTau), properTime: plus(state.properTime, own) }
    : { t: state.t, properTime: state.properTime };
  if (lock === 'look') return { ...moved, ...clocks, position: state.position };
  const { rapidity, direction } = state.velocity;
  const way =
    arc.push && dTau > 0
      ? wayAtSpeed(state.velocity, arc.push, dTau, c)
      : scale(direction, Math.tanh(rapidity) * c * dTau);
  return { ...moved, ...clocks, position: shifted(state.position, way), orientation: state.orientation };
}

function freely(state: FlightState, { push, reached, dTau: whole }: FlightArc, c: number, dTau: number): FlightState {
  if (!push) return coastFlight(state, dTau, c);
  const moved = accelerateFlight(state, push, dTau, c);
  return reached && dTau === whole ? { ...moved, velocity: reached } : moved;
}

export const flyArcs = (state: FlightState, arcs: readonly FlightArc[], conditions: FlightConditions): FlightState =>
  arcs.reduce((now, arc) => flyArc(now, arc, conditions), state);

/** With the orientation to which the ship turns at the beginning. */
export const turnedFirst = ([first, ...rest]: readonly FlightArc[], orientation: Quat): readonly FlightArc[] =>
  first ? [{ ...first, orientation: normalizeQuat(orientation) }, ...rest] : [];

/** The arcs of the first `dt` [s]. */
export function firstArcs(arcs: readonly FlightArc[], dt: number): readonly FlightArc[] {
  const taken: FlightArc[] = [];
  let left = dt;
  for (const arc of arcs) {
    if (left <= 0) break;
    const { reached: _, ...shortened } = { ...arc, dTau: left };
    taken.push(arc.dTau <= left ? arc : shortened);
    left -= arc.dTau;
  }
  return left > 0 ? [...taken, { dTau: left }] : taken;
}

/** Constant proper acceleration of `size` [m/s²] towards a target velocity for `dt` [s], and coasting once it is reached. c [m/s]. */
export function seekArcs(velocity: Boost, target: Boost, size: number, dt: number, c: number): readonly FlightArc[] {
  const missing = relativeBoost(target, velocity);
  if (missing.rapidity === 0) return [{ dTau: dt }];
  const push = { direction: missing.direction, size };
  return firstArcs([{ dTau: (missing.rapidity * c) / size, push, reached: target }], dt);
}
