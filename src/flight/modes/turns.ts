import { type Quat, rotate } from '../../math/quat.ts';
import { dot, length, negate, type Vec3 } from '../../math/vec3.ts';
import { levelled, NOSE, noseTowards, turnFreely, turnLevel } from '../turning.ts';
import type { FlightMoment } from './flightMode.ts';

/** How fast a ship rolls out [rad/s], where the horizon is kept level. */
const LEVEL_RATE = 1.5;
/** How fast a nose turns to where it belongs [1/s]: the angle falls as e^(−rate·τ). */
const NOSE_RATE = 3;

/** Rolls out where the horizon is kept. */
const rollsOut = ({ dt, rules }: FlightMoment, orientation: Quat): Quat =>
  rules.level ? levelled(orientation, rules.up, LEVEL_RATE * dt) : orientation;

/** As a walker looks around: yaw about the scene's up, no roll. */
export function turnsLevel(moment: FlightMoment): Quat {
  const { state, controls, rules } = moment;
  const turned = length(controls.turn) > 0 ? turnLevel(state.orientation, controls.turn, rules.up) : state.orientation;
  return rollsOut(moment, turned);
}

/** About the ship's own axes, unless the horizon is kept. */
export const turnsFreely = (moment: FlightMoment): Quat =>
  moment.rules.level ? turnsLevel(moment) : turnFreely(moment.state.orientation, moment.controls.turn);

/** By hand, and then the nose turns to a direction. */
function turnsTowards(moment: FlightMoment, direction: Vec3): Quat {
  return rollsOut(moment, noseTowards(turnsFreely(moment), direction, -Math.expm1(-NOSE_RATE * moment.dt)));
}

/** The nose turns into the motion; while one flies backwards, the tail does. */
export function turnsIntoMotion(moment: FlightMoment): Quat {
  const { velocity, orientation } = moment.state;
  if (velocity.rapidity === 0) return turnsFreely(moment);
  const forwards = dot(rotate(orientation, NOSE), velocity.direction) >= 0;
  return turnsTowards(moment, forwards ? velocity.direction : negate(velocity.direction));
}

/** As the pilot lets the ship hold its nose. `push`: where its engine pushes, if that does not depend on the nose. */
export function turnsAsHeld(moment: FlightMoment, push?: Vec3): Quat {
  const { velocity } = moment.state;
  const { attitude } = moment.rules;
  const aim =
    attitude === 'push' ? push : attitude === 'hand' || velocity.rapidity === 0 ? undefined : velocity.direction;
  if (!aim) return turnsFreely(moment);
  return turnsTowards(moment, attitude === 'against' ? negate(aim) : aim);
}
