import { fromAxisAngle, multiply, normalizeQuat, type Quat, rotate } from '../../math/quat.ts';
import { addScaled, dot, length, normalize, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { gamma, properVelocity, rapidity } from '../../physics/lorentz/boost.ts';
import { accelerate, coast, type ObserverState } from '../../physics/lorentz/observer.ts';
import { relativeVelocity } from '../../physics/lorentz/velocity.ts';

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

/** Proper velocity that the controls ask for, world frame; undefined: keep the current one. */
export function targetVelocity(state: ObserverState, controls: FlightControls, rules: FlightRules): Vec3 | undefined {
  const [right, up, back] = controls.thrust;
  const push = length(controls.thrust);
  if (push === 0) return rules.cruise ? undefined : ZERO;
  const direction = normalize(addScaled(rotate(state.orientation, [right, 0, back]), rules.up, up));
  const speed = controls.fullSpeed ? rules.maxSpeed : walkingSpeed(rules);
  return properVelocity(scale(direction, speed * Math.min(1, push)));
}

/**
 * The observer after dt [s] of real time, which equals the observer's proper time: constant proper acceleration towards
 * the target velocity, integrated exactly. With world time paused the observer still moves, through a frozen instant.
 */
export function stepFlight(
  state: ObserverState,
  controls: FlightControls,
  dt: number,
  rules: FlightRules,
): ObserverState {
  const moved = thrust(state, targetVelocity(state, controls, rules), dt, rules);
  if (rules.lock === 'free') return rules.playing ? moved : { ...moved, t: state.t, properTime: state.properTime };
  const held = { ...moved, ...lockedClocks(state, moved.u, dt, rules) };
  if (rules.lock === 'look') return { ...held, position: state.position };
  const position = addScaled(state.position, moved.u, (rules.c * dt) / gamma(moved.u));
  return { ...held, position, orientation: state.orientation };
}

/** With a lock, world time runs as real time: `look` stays in place, and `fly` is at rest for the picture. */
function lockedClocks(state: ObserverState, u: Vec3, dt: number, { lock, playing }: FlightRules) {
  if (!playing) return { t: state.t, properTime: state.properTime };
  return { t: state.t + dt, properTime: state.properTime + (lock === 'look' ? dt / gamma(u) : dt) };
}

function thrust(state: ObserverState, target: Vec3 | undefined, dt: number, rules: FlightRules): ObserverState {
  const missing = target && relativeVelocity(target, state.u);
  const change = missing ? rapidity(missing) : 0;
  if (!target || !missing || change === 0) return coast(state, dt, rules.c);
  const a = properAcceleration(state.u, target, rules);
  const burn = Math.min(dt, (change * rules.c) / a);
  const burnt = accelerate(state, scale(normalize(missing), a), burn, rules.c);
  return burn < dt ? coast({ ...burnt, u: target }, dt - burn, rules.c) : burnt;
}

/** Proper acceleration [m/s²]: a stronger one where the current or the target speed exceeds the walking speed. */
function properAcceleration(u: Vec3, target: Vec3, rules: FlightRules): number {
  const walk = Math.atanh(walkingSpeed(rules));
  const fast = Math.max(rapidity(u), rapidity(target)) > walk * 1.001;
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
