import { length, scale, sub } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { apparentPosition, inverseApparentPosition } from '../../physics/optics/apparentPosition.ts';
import { dopplerFactor } from '../../physics/optics/doppler.ts';
import type { ObserverEvent } from '../../physics/worldLines/kinds/worldLineKind.ts';
import { emissionEvent, type NewtonOptions, newtonEmissionTime } from '../../physics/worldLines/lightCone.ts';
import { positionAt, properVelocityAt, velocityAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import type { ViewRecord } from './viewRecord.ts';

function newtonEvent(line: WorldLine, observer: ObserverEvent, c: number, newton: NewtonOptions) {
  const t = newtonEmissionTime(line, observer, c, newton);
  const position = positionAt(line, t, c);
  return { t, position, offset: sub(position, observer.position) };
}

/** What the observer sees: events on the past light cone, with aberration and Doppler shift. */
export const lightCone: ViewRecord = {
  title: msg`Seen`,
  summary: msg`what is seen`,
  help: msg`What you see`,
  luminous: () => true,
  relativistic: true,
  hypersurface: ({ lightDelay }) => (lightDelay ? 'past-light-cone' : 'now'),
  placement: ({ aberration }) => (aberration ? 'apparent' : 'plain'),
  rayToward(n, u, { lightDelay, aberration }) {
    const dx = aberration ? inverseApparentPosition(n, u) : n;
    return [lightDelay ? -length(dx) : 0, ...dx];
  },
  probe(line, observer, c, { newton }) {
    const event = newton ? newtonEvent(line, observer, c, newton) : emissionEvent(line, observer, c);
    if (!event) return undefined;
    const { t: time, position, offset } = event;
    return {
      time,
      position,
      velocity: scale(velocityAt(line, time, c), 1 / c),
      apparent: apparentPosition(offset, observer.u),
      doppler: dopplerFactor(offset, observer.u, properVelocityAt(line, time, c)),
    };
  },
};
