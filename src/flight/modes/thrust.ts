import { rotate } from '../../math/quat.ts';
import { length, normalize, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import type { FlightArc } from '../arc.ts';
import type { FlightMode, FlightMoment } from './flightMode.ts';
import { brakingArcs, limitedArcs } from './pushes.ts';
import { turnsAsHeld, turnsIntoMotion } from './turns.ts';

/** Pushes along the ship's own axes; without controls it coasts. */
function thrustArcs(moment: FlightMoment): readonly FlightArc[] {
  const { state, controls, dt, rules } = moment;
  if (controls.brake) return brakingArcs(moment);
  const [right, up, back] = controls.thrust;
  const push: Vec3 = [right * rules.across, up * rules.across, back * rules.along];
  const size = length(push);
  if (size === 0) return [{ dTau: dt }];
  return limitedArcs(state.velocity, { direction: rotate(state.orientation, normalize(push)), size }, dt, rules);
}

/** A spaceship: proper acceleration along its own axes, six degrees of freedom. */
export const thrustMode: FlightMode = {
  title: msg`Thrust`,
  help: msg`The keys are engines: a constant proper acceleration along the ship's own axes. Let go, and you coast.`,
  strength: ({ along }) => along,
  orientation: (moment) => turnsAsHeld(moment),
  arcs: thrustArcs,
};

/** A ship whose nose follows its motion. */
export const vehicleMode: FlightMode = {
  title: msg`Vehicle`,
  help: msg`As Thrust, and the nose turns into the motion.`,
  strength: ({ along }) => along,
  orientation: turnsIntoMotion,
  arcs: thrustArcs,
};
