import { rotate } from '../../math/quat.ts';
import { add, addScaled, dot, length, normalize, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { properVelocityOf } from '../boost.ts';
import type { FlightMode } from './flightMode.ts';
import { turnsLevel } from './turns.ts';
import { velocityArcs, velocityStrength, wantedVelocity } from './velocity.ts';

const withoutUp = (v: Vec3, up: Vec3): Vec3 => addScaled(v, up, -dot(v, up));

/** As a walker or a car: the height stays, wherever one looks. */
export const driveMode: FlightMode = {
  title: msg`Drive`,
  help: msg`As Velocity, at one height: the keys go where you look, along the ground.`,
  strength: velocityStrength,
  orientation: turnsLevel,
  arcs(moment) {
    const { state, controls, rules } = moment;
    const { velocity } = state;
    const [right, , back] = controls.thrust;
    const thrust: Vec3 = [right, 0, back];
    if (length(thrust) === 0 || controls.brake) {
      const level = withoutUp(properVelocityOf(velocity), rules.up);
      const kept = rules.cruise && !controls.brake ? Math.asinh(length(level)) : 0;
      return velocityArcs(moment, { direction: normalize(level, velocity.direction), rapidity: kept });
    }
    // Where one looks up or down, ahead is still ahead.
    const level = (axis: Vec3): Vec3 => normalize(withoutUp(rotate(state.orientation, axis), rules.up), ZERO);
    const wanted = add(scale(level([1, 0, 0]), right), scale(level([0, 0, 1]), back));
    return velocityArcs(moment, wantedVelocity(wanted, velocity.direction, { ...controls, thrust }, rules));
  },
};
