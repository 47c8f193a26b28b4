import { add, scale, sub } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { inverseBoost } from '../../physics/lorentz/boost.ts';
import type { NewtonOptions } from '../../physics/worldLines/lightCone.ts';
import {
  newtonSimultaneousTime,
  simultaneitySlice,
  simultaneousPosition,
} from '../../physics/worldLines/simultaneity.ts';
import { positionAt, velocityAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import type { ProbeObserver, ViewRecord } from './viewRecord.ts';

function exactEvent(line: WorldLine, observer: ProbeObserver, c: number) {
  const { offset, ahead } = simultaneitySlice(line, observer, observer.u, c);
  return { offset, time: observer.t + ahead / c };
}

function newtonEvent(line: WorldLine, observer: ProbeObserver, c: number, newton: NewtonOptions) {
  const time = newtonSimultaneousTime(line, observer, observer.u, c, newton);
  return { offset: sub(positionAt(line, time, c), observer.position), time };
}

/** Positions at the observer's time, in his frame. */
export const simultaneity: ViewRecord = {
  title: msg`Simultaneity`,
  summary: msg`positions at one instant of the observer`,
  help: msg`positions at your own instant (a “god’s eye” view)`,
  luminous: () => false,
  relativistic: true,
  hypersurface: () => 'slice',
  placement: () => 'contracted',
  // The events (0, s n′) of the observer's frame.
  rayToward: (n, u) => inverseBoost([0, ...n], u),
  probe(line, observer, c, { newton }) {
    const { offset, time } = newton ? newtonEvent(line, observer, c, newton) : exactEvent(line, observer, c);
    const velocity = scale(velocityAt(line, time, c), 1 / c);
    const apparent = simultaneousPosition(offset, observer.u);
    return { time, position: add(observer.position, offset), velocity, apparent, doppler: 1 };
  },
};
