import { add, scale } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { inverseBoost } from '../../physics/lorentz/boost.ts';
import { simultaneitySlice, simultaneousPosition } from '../../physics/worldLines/simultaneity.ts';
import { velocityAt } from '../../physics/worldLines/worldLine.ts';
import type { ViewRecord } from './viewRecord.ts';

/** Positions at the observer's time, in his frame. */
export const simultaneity: ViewRecord = {
  title: msg`Simultaneity`,
  summary: msg`positions at one instant of the observer`,
  help: msg`positions at your own instant (a “god’s eye” view)`,
  luminous: false,
  relativistic: true,
  hypersurface: () => 'slice',
  placement: () => 'contracted',
  // The events (0, s n′) of the observer's frame.
  rayToward: (n, u) => inverseBoost([0, ...n], u),
  probe(line, observer, c) {
    const { offset, ahead } = simultaneitySlice(line, observer, observer.u, c);
    const time = observer.t + ahead / c;
    const velocity = scale(velocityAt(line, time, c), 1 / c);
    const apparent = simultaneousPosition(offset, observer.u);
    return { time, position: add(observer.position, offset), velocity, apparent, doppler: 1 };
  },
};
