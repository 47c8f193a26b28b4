import { scale, sub } from '../../math/vec3.ts';
import { positionAt, velocityAt } from '../../physics/worldLines/worldLine.ts';
import type { ViewRecord } from './viewRecord.ts';

/** The view with c = ∞. */
export const galilean: ViewRecord = {
  title: ['c = ∞', 'c = ∞'],
  summary: 'c = ∞',
  help: ['the world with infinite c', '光速无穷大的世界'],
  luminous: false,
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
