import { length } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { type FlightArc, firstArcs } from '../arc.ts';
import { rapidityLimit } from '../controls.ts';
import { planTrip } from '../trip.ts';
import type { FlightMode, FlightMoment } from './flightMode.ts';
import { brakingArcs } from './pushes.ts';
import { turnsAsHeld } from './turns.ts';

function autopilotArcs(moment: FlightMoment): readonly FlightArc[] {
  const { state, controls, dt, rules } = moment;
  const { destination, c, along } = rules;
  if (!destination || controls.brake || length(controls.thrust) > 0) return brakingArcs(moment);
  return firstArcs(planTrip(state, destination, { c, acceleration: along, limit: rapidityLimit(rules) }), dt);
}

/** Flies to a place and stops there, as fast as the engine along the nose allows. */
export const autopilotMode: FlightMode = {
  title: msg`Autopilot`,
  help: msg`Flies to the place that you choose and stops there: half the way it accelerates, half the way it brakes.`,
  strength: ({ along }) => along,
  orientation: (moment) => turnsAsHeld(moment, autopilotArcs(moment)[0]?.push?.direction),
  arcs: autopilotArcs,
};
