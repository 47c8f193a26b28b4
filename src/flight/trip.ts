import { length, negate, normalize, sub, type Vec3 } from '../math/vec3.ts';
import { type FlightArc, flyArcs } from './arc.ts';
import { bearing } from './boost.ts';
import { type FlightState, observerOf } from './flightState.ts';

/** How a trip is flown. */
export interface TripRules {
  /** [m/s] */
  readonly c: number;
  /** Proper acceleration [m/s²]. */
  readonly acceleration: number;
  /** Rapidity at which one coasts instead. */
  readonly limit: number;
}

/** How far from its course [rad] a motion may be for a trip to go on without a stop. */
const ON_COURSE = 1e-9;
/** One has arrived where that part of the distances from the world's origin is left. */
const ARRIVED = 1e-12;

/**
 * The fastest trip to a place at rest at one proper acceleration a, in closed form: half the way forwards, the turn-around, half
 * the way back to rest. From the rapidity φ₀ at the distance d the turn-around is at φ, with coasting at the limit φ_L before:
 *
 *     sinh²(φ/2) = (ad/c² + 2 sinh²(φ₀/2))/4,  Δτ = c(2φ − φ₀)/a
 *
 * What flies elsewhere, or too fast, stops first. docs/physics.md §2.7.
 */
export function planTrip(state: FlightState, destination: Vec3, rules: TripRules): readonly FlightArc[] {
  const { position } = observerOf(state);
  const there = sub(destination, position);
  const { direction, rapidity } = state.velocity;
  const distance = length(there);
  if (rapidity === 0 && distance <= ARRIVED * (length(position) + length(destination))) return [];
  const ahead = normalize(there, direction);
  const onCourse = rapidity === 0 || isAlong(direction, ahead);
  const excess = squareOfHalf(rapidity);
  const scaled = (rules.acceleration * distance) / rules.c ** 2;
  if (!onCourse || 2 * excess > scaled * (1 + ON_COURSE)) {
    const stop = push(negate(direction), rapidity, rules);
    const after = { c: rules.c, lock: 'free', playing: true } as const;
    const stopped = { ...stop, reached: { direction, rapidity: 0 } };
    return [stopped, ...planTrip(flyArcs(state, [stopped], after), destination, rules)];
  }
  // The motion's own direction where there is one: an engine fixed otherwise would leave a side velocity of sinh φ · 10⁻¹⁶.
  const course = rapidity === 0 ? ahead : direction;
  const turnAround = Math.max(rapidity, 2 * Math.asinh(Math.sqrt((scaled + 2 * excess) / 4)));
  const top = Math.max(rapidity, Math.min(turnAround, rules.limit));
  const coasted = ((scaled + 2 * excess - 4 * squareOfHalf(top)) * rules.c) / (rules.acceleration * Math.sinh(top));
  return [
    push(course, top - rapidity, rules),
    { dTau: turnAround > rules.limit ? coasted : 0 },
    { ...push(negate(course), top, rules), reached: { direction: course, rapidity: 0 } },
  ].filter(({ dTau }) => dTau > 0);
}

const squareOfHalf = (rapidity: number): number => Math.sinh(rapidity / 2) ** 2;

const push = (direction: Vec3, gained: number, { acceleration, c }: TripRules): FlightArc => ({
  dTau: (gained * c) / acceleration,
  push: { direction, size: acceleration },
});

const isAlong = (n: Vec3, a: Vec3): boolean => {
  const { cosHalfSquared, across } = bearing(n, a);
  return cosHalfSquared > 0.5 && length(across) <= ON_COURSE;
};

/** Proper time of arcs [s]. */
export const durationOf = (arcs: readonly FlightArc[]): number => arcs.reduce((sum, { dTau }) => sum + dTau, 0);
