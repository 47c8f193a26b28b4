import { rotate } from '../../math/quat.ts';
import { add, dot, length, normalize, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { type Boost, compose, properVelocityOf, relativeBoost } from '../boost.ts';
import type { FlightMode, FlightMoment } from './flightMode.ts';
import { onSlope, withoutUp } from './slope.ts';
import { turnsLevel } from './turns.ts';
import { velocityArcs, velocityStrength, wantedVelocity } from './velocity.ts';

/** As a walker or a car: the height stays, wherever one looks; over ground, in the frame where it rests and along its slope. */
export const driveMode: FlightMode = {
  title: msg`Drive`,
  help: msg`As Velocity, along the ground wherever you look, or at one height where there is none.`,
  strength: velocityStrength,
  orientation: turnsLevel,
  arcs(moment) {
    const { velocity, normal } = groundOf(moment);
    const own = relativeBoost(moment.state.velocity, velocity);
    return velocityArcs(moment, compose(velocity, wantedAlong(moment, own, normal)));
  },
};

const groundOf = ({ state, rules }: FlightMoment) =>
  rules.ground ?? { velocity: { ...state.velocity, rapidity: 0 }, normal: rules.up };

/** The velocity that is asked for, along a plane with that normal, in the frame where the plane rests. `own`: the present one there. */
function wantedAlong({ state, controls, rules }: FlightMoment, own: Boost, normal: Vec3): Boost {
  const { up } = rules;
  const [right, , back] = controls.thrust;
  const thrust: Vec3 = [right, 0, back];
  if (length(thrust) === 0 || controls.brake) {
    const along = withoutUp(properVelocityOf(own), normal);
    const kept = rules.cruise && !controls.brake ? Math.asinh(length(along)) : 0;
    return { direction: normalize(along, own.direction), rapidity: kept };
  }
  // Where one looks up or down, ahead is still ahead.
  const level = (axis: Vec3): Vec3 => normalize(withoutUp(rotate(state.orientation, axis), up), ZERO);
  const wanted = add(scale(level([1, 0, 0]), right), scale(level([0, 0, 1]), back));
  const asked = wantedVelocity(wanted, own.direction, { ...controls, thrust }, rules);
  return asked.rapidity === 0 || dot(normal, up) === 1
    ? asked
    : { ...asked, direction: onSlope(asked.direction, normal, up) };
}
