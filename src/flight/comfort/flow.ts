import { conjugate, multiply, rotationAngle } from '../../math/quat.ts';
import { length, sub } from '../../math/vec3.ts';
import type { Lock } from '../arc.ts';
import { type Boost, gyroscopeRotation, relativeBoost } from '../boost.ts';
import { type FlightState, observerOf } from '../flightState.ts';
import type { HeldCamera } from '../hold.ts';

/** What turns or speeds up by more in one moment [rad, rapidity] is a cut, which no eye follows: a turn in steps, a stop at a wall. */
const CUT = 0.2;

/** A moment of a flight, as it is watched. */
export interface WatchedMoment {
  readonly before: FlightState;
  readonly after: FlightState;
  /** How long it lasts for who watches [s]. */
  readonly dt: number;
  readonly lock: Lock;
  /** The camera of one who walks about in what is held, before and after. */
  readonly walked?: { readonly before: HeldCamera; readonly after: HeldCamera } | undefined;
  /** How far away what is passed is [m]. */
  readonly distance: number;
}

const STILL: Boost = { direction: [1, 0, 0], rapidity: 0 };

/**
 * How fast directions move in the picture at most [rad/s]: by the turn of the ship against gyroscopes, by aberration, and by the way past things.
 *
 *     ω + |a|/c + |Δx|/(d Δτ)
 *
 * Aberration at constant proper acceleration moves the direction at θ′ to it by dθ′/dτ = −(a/c) sin θ′. In what is held it is ω + |Δvantage|/(d Δt):
 * things stay where they are seen.
 */
export function pictureFlow({ before, after, dt, lock, walked, distance }: WatchedMoment): number {
  if (!(dt > 0)) return 0;
  if (walked) {
    const { before: from, after: to } = walked;
    const turned = rotationAngle(multiply(to.orientation, conjugate(from.orientation)));
    return (smooth(turned) + length(sub(to.vantage, from.vantage)) / distance) / dt;
  }
  // With the lock `fly` the picture is that of one at rest.
  const gained: Boost = lock === 'fly' ? STILL : relativeBoost(after.velocity, before.velocity);
  const gyroscopes = multiply(gyroscopeRotation(before.velocity, gained), before.orientation);
  const turned = rotationAngle(multiply(after.orientation, conjugate(gyroscopes)));
  const way = length(sub(observerOf(after).position, observerOf(before).position));
  return (smooth(turned) + smooth(gained.rapidity) + way / distance) / dt;
}

const smooth = (change: number): number => (change > CUT ? 0 : change);
