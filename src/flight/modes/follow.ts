import { length } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { compose } from '../boost.ts';
import type { FlightMode } from './flightMode.ts';
import { turnsAsHeld } from './turns.ts';
import { pushDirection, velocityArcs, velocityStrength, wantedVelocity } from './velocity.ts';

/** Takes a body's velocity, to sit in its rest frame; controls move one there, as they do at rest in the world. */
export const followMode: FlightMode = {
  title: msg`Follow`,
  help: msg`Takes the velocity of what you follow, and stays in its rest frame. The keys move you there.`,
  strength: velocityStrength,
  orientation: (moment) => turnsAsHeld(moment),
  arcs(moment) {
    const { state, controls, dt, rules } = moment;
    const { followed } = rules;
    if (!followed) return [{ dTau: dt }];
    if (length(controls.thrust) === 0) return velocityArcs(moment, followed);
    const wanted = pushDirection(state.orientation, controls.thrust, rules.up);
    const there = wantedVelocity(wanted, state.velocity.direction, controls, rules);
    return velocityArcs(moment, compose(followed, there));
  },
};
