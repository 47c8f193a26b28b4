import { length, scale } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { apparentPosition, inverseApparentPosition } from '../../physics/optics/apparentPosition.ts';
import { dopplerFactor } from '../../physics/optics/doppler.ts';
import { emissionEvent } from '../../physics/worldLines/lightCone.ts';
import type { ViewRecord } from './viewRecord.ts';

/** What the observer sees: events on the past light cone, with aberration and Doppler shift. */
export const lightCone: ViewRecord = {
  title: msg`Seen`,
  summary: msg`what is seen`,
  help: msg`What you see`,
  luminous: true,
  relativistic: true,
  hypersurface: ({ lightDelay }) => (lightDelay ? 'past-light-cone' : 'now'),
  placement: ({ aberration }) => (aberration ? 'apparent' : 'plain'),
  rayToward(n, u, { lightDelay, aberration }) {
    const dx = aberration ? inverseApparentPosition(n, u) : n;
    return [lightDelay ? -length(dx) : 0, ...dx];
  },
  probe(line, observer, c) {
    const event = emissionEvent(line, observer, c);
    if (!event) return undefined;
    const velocity = scale(event.velocity, 1 / c);
    const doppler = dopplerFactor(event.offset, observer.u, properVelocity(velocity));
    const apparent = apparentPosition(event.offset, observer.u);
    return { time: event.t, position: event.position, velocity, apparent, doppler };
  },
};
