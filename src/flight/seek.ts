import { fromAxisAngle, multiply, normalizeQuat, type Quat, rotate } from '../math/quat.ts';
import { plus } from '../math/sum.ts';
import { addScaled, dot, length, normalize, scale, type Vec3, ZERO } from '../math/vec3.ts';
import { type Boost, relativeBoost } from './boost.ts';
import { accelerateFlight, coastFlight, type FlightState, shifted } from './flightState.ts';

/**
 * `free`: the observer flies. `look`: has a velocity but stays in place, to see the effect of speed at one point.
 * `fly`: moves, while the picture is that of an observer at rest.
 */
export type Lock = 'free' | 'look' | 'fly';
export const LOCKS: readonly Lock[] = ['free', 'look', 'fly'];

/** Input of the user at one moment. */
export interface FlightControls {
  /** In camera axes, each −1 … 1: right, along the scene's up axis, back. */
  readonly thrust: Vec3;
  readonly fullSpeed: boolean;
}
export const NO_CONTROLS: FlightControls = { thrust: ZERO, fullSpeed: false };

export interface FlightRules {
  /** [m/s] */
  readonly c: number;
  /** Upper speed limit as a fraction of c. */
  readonly maxSpeed: number;
  readonly lock: Lock;
  /** Whether the velocity is kept when no key is pressed; otherwise the observer brakes to rest. */
  readonly cruise: boolean;
  /** Whether world time runs. */
  readonly playing: boolean;
  readonly up: Vec3;
}

/** Speed limit without the full-speed key [m/s]. */
const WALKING_SPEED = 8;
/** Proper times to reach the maximum speed, and the walking speed, from rest [s]. */
const SPRINT_TIME = 2;
const WALK_TIME = 0.5;

/** The smaller of half the maximum speed and 8 m/s, as a fraction of c. */
export const walkingSpeed = ({ c, maxSpeed }: Pick<FlightRules, 'c' | 'maxSpeed'>): number =>
  Math.min(maxSpeed / 2, WALKING_SPEED / c);

/** Velocity that the controls ask for, world frame; undefined: keep the current one. */
function targetVelocity(state: FlightState, controls: FlightControls, rules: FlightRules): Boost | undefined {
  const [right, up, back] = controls.thrust;
  const push = length(controls.thrust);
  if (push === 0) return rules.cruise ? undefined : { ...state.velocity, rapidity: 0 };
  const wanted = addScaled(rotate(state.orientation, [right, 0, back]), rules.up, up);
  const speed = controls.fullSpeed ? rules.maxSpeed : walkingSpeed(rules);
  return {
    direction: normalize(wanted, state.velocity.direction),
    rapidity: length(wanted) > 0 ? Math.atanh(speed * Math.min(1, push)) : 0,
  };
}

/**
 * The observer after dt [s] of real time, which equals the observer's proper time: constant proper acceleration towards
 * the target velocity, integrated exactly. With world time paused the observer still moves, through a frozen instant.
 */
export function stepFlight(state: FlightState, controls: FlightControls, dt: number, rules: FlightRules): FlightState {
  const moved = thrust(state, targetVelocity(state, controls, rules), dt, rules);
  if (rules.lock === 'free') return rules.playing ? moved : { ...moved, t: state.t, properTime: state.properTime };
  const speed = Math.tanh(moved.velocity.rapidity);
  const held = { ...moved, ...lockedClocks(state, moved.velocity, dt, rules) };
  if (rules.lock === 'look') return { ...held, position: state.position };
  const position = shifted(state.position, scale(moved.velocity.direction, speed * rules.c * dt));
  return { ...held, position, orientation: state.orientation };
}

/** With a lock, world time runs as real time: `look` stays in place, and `fly` is at rest for the picture. */
function lockedClocks(state: FlightState, { rapidity }: Boost, dt: number, { lock, playing }: FlightRules) {
  if (!playing) return { t: state.t, properTime: state.properTime };
  return { t: plus(state.t, dt), properTime: plus(state.properTime, lock === 'look' ? dt / Math.cosh(rapidity) : dt) };
}

function thrust(state: FlightState, target: Boost | undefined, dt: number, rules: FlightRules): FlightState {
  const missing = target && relativeBoost(target, state.velocity);
  if (!target || !missing || missing.rapidity === 0) return coastFlight(state, dt, rules.c);
  const size = properAcceleration(state.velocity, target, rules);
  const burn = Math.min(dt, (missing.rapidity * rules.c) / size);
  const burnt = accelerateFlight(state, { direction: missing.direction, size }, burn, rules.c);
  return burn < dt ? coastFlight({ ...burnt, velocity: target }, dt - burn, rules.c) : burnt;
}

/** Proper acceleration [m/s²]: a stronger one where the current or the target speed exceeds the walking speed. */
function properAcceleration(velocity: Boost, target: Boost, rules: FlightRules): number {
  const walk = Math.atanh(walkingSpeed(rules));
  const fast = Math.max(velocity.rapidity, target.rapidity) > walk * 1.001;
  return rules.c * (fast ? Math.atanh(rules.maxSpeed) / SPRINT_TIME : walk / WALK_TIME);
}

/**
 * Rotates the view: yaw about the scene's up axis, then pitch about the camera's right axis [rad]; pitch is clamped at
 * the vertical.
 */
export function turnView(orientation: Quat, yaw: number, pitch: number, up: Vec3): Quat {
  const turned = multiply(fromAxisAngle(up, yaw), orientation);
  const forward = rotate(turned, [0, 0, -1]);
  const elevation = Math.asin(Math.max(-1, Math.min(1, dot(forward, up))));
  const limit = Math.PI / 2 - 0.02;
  const bounded = Math.max(-limit, Math.min(limit, elevation + pitch)) - elevation;
  return normalizeQuat(multiply(fromAxisAngle(rotate(turned, [1, 0, 0]), bounded), turned));
}

/** Wraps world time [s] to the timeline: at the end it loops or stops. */
export function wrapTime(t: number, start: number, end: number, loop: boolean): number {
  if (end <= start || t <= end) return t;
  return loop ? start + ((t - start) % (end - start)) : end;
}
