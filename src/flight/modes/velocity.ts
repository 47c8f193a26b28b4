import { type Quat, rotate } from '../../math/quat.ts';
import { addScaled, length, normalize, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { type FlightArc, seekArcs } from '../arc.ts';
import type { Boost } from '../boost.ts';
import type { FlightControls, FlightRules } from '../controls.ts';
import type { FlightMode, FlightMoment } from './flightMode.ts';
import { turnsLevel } from './turns.ts';

/** Speed limit without the full-speed key [m/s]. */
const WALKING_SPEED = 8;
/** Proper times to reach the maximum speed, and the walking speed, from rest [s]. */
const SPRINT_TIME = 2;
const WALK_TIME = 0.5;

/** The smaller of half the maximum speed and 8 m/s, as a fraction of c. */
export const walkingSpeed = ({ c, maxSpeed }: Pick<FlightRules, 'c' | 'maxSpeed'>): number =>
  Math.min(maxSpeed / 2, WALKING_SPEED / c);

/** The speed that a full push asks for, as a fraction of c. */
export const askedSpeed = (
  { fullSpeed }: Pick<FlightControls, 'fullSpeed'>,
  rules: Pick<FlightRules, 'c' | 'maxSpeed'>,
): number => (fullSpeed ? rules.maxSpeed : walkingSpeed(rules));

/** Where a push points: right and back as the nose is turned, up along the scene's axis. As long as the push where both are perpendicular. */
export const pushDirection = (orientation: Quat, [right, up, back]: Vec3, axis: Vec3): Vec3 =>
  addScaled(rotate(orientation, [right, 0, back]), axis, up);

/** The velocity that a push of the controls asks for, with `wanted` its direction in the world. */
export function wantedVelocity(wanted: Vec3, before: Vec3, controls: FlightControls, rules: FlightRules): Boost {
  const speed = askedSpeed(controls, rules);
  return {
    direction: normalize(wanted, before),
    rapidity: length(wanted) > 0 ? Math.atanh(speed * Math.min(1, length(controls.thrust))) : 0,
  };
}

const fastPush = ({ c, maxSpeed }: FlightRules): number => (c * Math.atanh(maxSpeed)) / SPRINT_TIME;
const walkingPush = (rules: FlightRules): number => (rules.c * Math.atanh(walkingSpeed(rules))) / WALK_TIME;

/** The greatest proper acceleration of modes that fly to velocities [m/s²]. */
export const velocityStrength = (rules: FlightRules): number => Math.max(fastPush(rules), walkingPush(rules));

/** Flies to a velocity, stronger where that or the present one exceeds the walking speed. */
export function velocityArcs({ state, dt, rules }: FlightMoment, target: Boost): readonly FlightArc[] {
  const walk = Math.atanh(walkingSpeed(rules));
  const fast = Math.max(state.velocity.rapidity, target.rapidity) > walk * 1.001;
  const size = fast ? fastPush(rules) : walkingPush(rules);
  return seekArcs(state.velocity, target, size, dt, rules.c);
}

/** Controls ask for a velocity, and constant proper acceleration leads there; without controls one brakes, or cruises. */
export const velocityMode: FlightMode = {
  title: msg`Velocity`,
  help: msg`The keys ask for a velocity. Let go to brake.`,
  strength: velocityStrength,
  orientation: turnsLevel,
  arcs(moment) {
    const { state, controls, dt, rules } = moment;
    const { velocity } = state;
    const idle = length(controls.thrust) === 0 || controls.brake;
    if (idle && rules.cruise && !controls.brake) return [{ dTau: dt }];
    if (idle) return velocityArcs(moment, { ...velocity, rapidity: 0 });
    const wanted = pushDirection(state.orientation, controls.thrust, rules.up);
    return velocityArcs(moment, wantedVelocity(wanted, velocity.direction, controls, rules));
  },
};
