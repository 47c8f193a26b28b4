import { rotate } from '../../math/quat.ts';
import { addScaled, dot, length, normalize, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { properVelocityOf } from '../boost.ts';
import type { FlightMode } from './flightMode.ts';
import { turnsLevel } from './turns.ts';
import { velocityArcs, wantedVelocity } from './velocity.ts';

const withoutUp = (v: Vec3, up: Vec3): Vec3 => addScaled(v, up, -dot(v, up));

/** As a walker or a car: the height stays, wherever one looks. */
export const driveMode: FlightMode = {
  title: msg`Drive`,
  help: msg`As Velocity, at one height: the keys go where you look, along the ground.`,
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
    const right0 = withoutUp(rotate(state.orientation, [1, 0, 0]), rules.up);
    const back0 = withoutUp(rotate(state.orientation, [0, 0, 1]), rules.up);
    const wanted = addScaled(
      addScaled([0, 0, 0], normalize(right0, [0, 0, 0]), right),
      normalize(back0, [0, 0, 0]),
      back,
    );
    return velocityArcs(moment, wantedVelocity(wanted, velocity.direction, { ...controls, thrust }, rules));
  },
};
