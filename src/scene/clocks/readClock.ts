import { add, type Vec3 } from '../../math/vec3.ts';
import { gamma } from '../../physics/lorentz/boost.ts';
import { relativeVelocity } from '../../physics/lorentz/velocity.ts';
import { dopplerFactor } from '../../physics/optics/doppler.ts';
import { pastLightCone } from '../../physics/worldLines/lightCone.ts';
import { simultaneousTime } from '../../physics/worldLines/simultaneity.ts';
import { positionAt, properVelocityAt } from '../../physics/worldLines/worldLine.ts';
import { isAlive } from '../motion/lifetimes.ts';
import type { ProbeObserver } from '../views/viewRecord.ts';
import { type Clock, type ClockCarrier, clockTime } from './clock.ts';

/** What a clock shows at an event of its own. */
export interface ClockReading {
  /** World time of that event [s]. */
  readonly time: number;
  /** Where it is then, world frame [m]. */
  readonly position: Vec3;
  /** Proper time that it shows [s]; from when: `clockStart`. */
  readonly properTime: number;
  /** Its steps per step of the time it is compared with: the observer's own, or that of the world. */
  readonly rate: number;
}

/** Why a clock shows nothing: it does not exist yet, or no longer; or no light of it ever comes, from behind a horizon. */
export type ClockAbsence = 'unborn' | 'ended' | 'hidden';

/** A clock in three ways: as light shows it, and at two meanings of now. */
export interface ClockReadings {
  /** On the observer's past light cone. The rate is the Doppler factor, by his own time. */
  readonly seen: ClockReading | ClockAbsence;
  /** In the observer's slice of simultaneity. The rate is 1/γ of the relative motion, by the own time of an observer who coasts. */
  readonly slice: ClockReading | ClockAbsence;
  /** At the world time of the observer's event. The rate is 1/γ of its motion in the world, by world time. */
  readonly world: ClockReading | ClockAbsence;
}

/**
 * What a clock shows to an observer; c [m/s]. With Δx from the observer to the clock, world frame:
 *
 *     seen:   c(t_o − t) = |Δx|       dτ/dτ_o = D = γ_o(1 + β_o·n)/[γ(1 + β·n)]
 *     slice:  c(t − t_o) = β_o·Δx     dτ/dτ_o = 1/[γ_o γ(1 − β_o·β)]
 *     world:  t = t_o                 dτ/dt = 1/γ
 *
 * docs/physics.md §3.1, §3.4, §4.13, §5.1. Readings have the digits that world time has in 64 bits.
 * @example
 * // It flies away at 0.6 c and passes here at time 0: at 8 s its light of 5 s is seen, when it showed 4 s.
 * const motion: Motion = { kind: 'uniform', pose: IDENTITY_POSE, velocity: [6, 0, 0] };
 * const [clock] = objectClocks([makeObject({ path: '/Ball', mesh: sphere(1), motion })], 10);
 * const { seen, slice } = readClock(clock!, { t: 8, position: [0, 0, 0], u: [0, 0, 0] }, 10);
 * seen; // { time: 5, properTime: 4, rate: 0.5 }
 * slice; // { time: 8, properTime: 6.4, rate: 0.8 }
 */
export function readClock(clock: Clock, observer: ProbeObserver, c: number): ClockReadings {
  const read = (find: FindEvent): ClockReading | ClockAbsence => readingOf(clock, find, c);
  return {
    seen: read(({ line }) => {
      const event = pastLightCone(line, observer, c);
      if (!event) return undefined;
      const time = observer.t - event.delay / c;
      const rate = dopplerFactor(event.offset, observer.u, properVelocityAt(line, time, c));
      return { time, position: add(observer.position, event.offset), rate };
    }),
    slice: read(({ line }) => {
      const time = simultaneousTime(line, observer, observer.u, c);
      const rate = 1 / gamma(relativeVelocity(properVelocityAt(line, time, c), observer.u));
      return { time, position: positionAt(line, time, c), rate };
    }),
    world: read(({ line }) => {
      const { t: time } = observer;
      return { time, position: positionAt(line, time, c), rate: 1 / gamma(properVelocityAt(line, time, c)) };
    }),
  };
}

/** An event of a carrier's world line, whether it exists then or not; undefined if there is none. */
type FindEvent = (carrier: ClockCarrier) => Omit<ClockReading, 'properTime'> | undefined;

/** By the last event at which a carrier exists; else what keeps the one whose life is nearest in time. */
function readingOf(clock: Clock, find: FindEvent, c: number): ClockReading | ClockAbsence {
  let found: Omit<ClockReading, 'properTime'> | undefined;
  let [absence, least]: [ClockAbsence, number] = ['hidden', Number.POSITIVE_INFINITY];
  for (const carrier of clock.carriers) {
    const event = find(carrier);
    if (!event) continue;
    const { birth, death } = carrier.lifetime;
    if (isAlive(carrier.lifetime, event.time)) {
      if (!found || event.time > found.time) found = event;
    } else if (event.time < birth ? birth - event.time < least : event.time - death < least)
      [absence, least] = event.time < birth ? ['unborn', birth - event.time] : ['ended', event.time - death];
  }
  return found ? { ...found, properTime: clockTime(clock, found.time, c) } : absence;
}

/** An observer who carries a clock. */
export interface ClockObserver extends ProbeObserver {
  /** What it shows [s]. */
  readonly properTime: number;
}

/** What the observer's own clock shows, in the same three ways. */
export function ownReadings({ t: time, position, properTime, u }: ClockObserver): ClockReadings {
  const own = { time, position, properTime, rate: 1 };
  return { seen: own, slice: own, world: { ...own, rate: 1 / gamma(u) } };
}

/**
 * What the clocks at rest in the world show, which are set to its time, at the place of the observer. He passes from one to the
 * next, so that what he reads runs γ times his own; each of them by itself is slow for him.
 */
export function worldReadings({ t: time, position, u }: ProbeObserver): ClockReadings {
  const passed = { time, position, properTime: time, rate: gamma(u) };
  return { seen: passed, slice: passed, world: { ...passed, rate: 1 } };
}
