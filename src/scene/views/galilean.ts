import { scale, sub } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { positionAt, velocityAt } from '../../physics/worldLines/worldLine.ts';
import type { ViewRecord } from './viewRecord.ts';

/** The view with c = ∞. */
export const galilean: ViewRecord = {
  title: 'c = ∞',
  summary: 'c = ∞',
  help: msg`the world with infinite c`,
  luminous: () => false,
  relativistic: false,
  hypersurface: () => 'now',
  placement: () => 'plain',
  rayToward: (n) => [0, ...n],
  probe(line, observer, c) {
    const position = positionAt(line, observer.t, c);
    const velocity = scale(velocityAt(line, observer.t, c), 1 / c);
    return { time: observer.t, position, velocity, apparent: sub(position, observer.position), doppler: 1 };
  },
};
