import { addScaled, length, scale, type Vec3 } from '../../math/vec3.ts';
import { type FlightArc, seekArcs } from '../arc.ts';
import { type Boost, bearing, compose } from '../boost.ts';
import { type FlightRules, rapidityLimit } from '../controls.ts';
import type { ProperAcceleration } from '../flightState.ts';
import type { FlightMoment } from './flightMode.ts';

/** Steps of the bisection for the moment at which a limit is reached: as many as 64 bits have digits. */
const BISECTIONS = 60;

/** Comes to rest by a push against the motion. */
export const brakingArcs = ({ state: { velocity }, dt, rules }: FlightMoment): readonly FlightArc[] =>
  seekArcs(velocity, { ...velocity, rapidity: 0 }, rules.along, dt, rules.c);

/**
 * A constant push for `dt` [s] that does not exceed the rapidity limit: there the part along the motion goes unused, and the
 * rest of the push turns the motion.
 */
export function limitedArcs(
  velocity: Boost,
  push: ProperAcceleration,
  dt: number,
  rules: Pick<FlightRules, 'c' | 'maxSpeed'>,
): readonly FlightArc[] {
  const limit = rapidityLimit(rules);
  const after = (dTau: number): Boost =>
    compose(velocity, { direction: push.direction, rapidity: (push.size * dTau) / rules.c });
  const { rapidity } = after(dt);
  if (rapidity <= limit || rapidity < velocity.rapidity) return [{ dTau: dt, push }];
  let [low, high] = [0, dt];
  // The rapidity first falls, if it does, and then rises: at `dt` it is above the limit, so that one crossing is left.
  for (let i = 0; i < BISECTIONS && velocity.rapidity < limit; i++) {
    const middle = (low + high) / 2;
    if (after(middle).rapidity <= limit) low = middle;
    else high = middle;
  }
  const turning = turningArc(after(low), push, dt - low, rules.c);
  return low > 0 ? [{ dTau: low, push }, turning] : [turning];
}

/**
 * What of a push turns a motion and keeps its rapidity φ: its part across, pointed back so far that
 * cosh φ = cosh φ cosh δ − sinh φ sinh δ sin α, thus sin α = tanh(δ/2)/tanh φ.
 */
function turningArc(velocity: Boost, { direction, size }: ProperAcceleration, dTau: number, c: number): FlightArc {
  const { across } = bearing(velocity.direction, direction);
  const part = length(across);
  const back = Math.tanh((part * size * dTau) / c / 2) / Math.tanh(velocity.rapidity);
  if (part === 0 || !(back < 1)) return { dTau };
  const aside: Vec3 = scale(across, Math.sqrt(1 - back * back) / part);
  return { dTau, push: { direction: addScaled(aside, velocity.direction, -back), size: part * size } };
}
