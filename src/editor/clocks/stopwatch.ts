import type { EventMark } from '../../graph/document/document.ts';
import { distance, sub } from '../../math/vec3.ts';
import { boost, velocity } from '../../physics/lorentz/boost.ts';
import { type FourVector, fourVector, interval } from '../../physics/lorentz/fourVector.ts';
import type { Clock } from '../../scene/clocks/clock.ts';
import { type ClockAbsence, type ClockObserver, readClock } from '../../scene/clocks/readClock.ts';

/** Marks the observer's own event. */
export const markOwn = (name: string, { t, position, properTime, u }: ClockObserver): EventMark => ({
  name,
  time: t,
  position,
  properTime,
  ownTime: properTime,
  u,
});

/** Marks what the observer sees of a thing: the event that its light left; or says why nothing is seen. c [m/s]. */
export function markSeen(name: string, clock: Clock, observer: ClockObserver, c: number): EventMark | ClockAbsence {
  const { seen } = readClock(clock, observer, c);
  if (typeof seen === 'string') return seen;
  const { time, position, properTime } = seen;
  return { name, thing: clock.path, time, position, properTime, ownTime: observer.properTime, u: observer.u };
}

/** How two events lie to each other; `same`: they are one. */
export type Separateness = 'timelike' | 'lightlike' | 'spacelike' | 'same';

/** What lies between two marked events, the second less the first. */
export interface MarkDifference {
  /** Of world time [s]. */
  readonly dt: number;
  /** In the world frame [m]. */
  readonly distance: number;
  /** Between the moments at which they were marked, by the observer's own clock [s]. */
  readonly dOwn: number;
  /** By the clock that was at both [s]; undefined if different ones were. */
  readonly dTau: number | undefined;
  /** Δx² − c²Δt² [m²]: negative if timelike. */
  readonly interval: number;
  readonly separateness: Separateness;
  /** In the frame of the observer as he moved when he marked the second [s]. */
  readonly dtObserver: number;
}

/** Rounding errors of an event that is found on a light cone, in steps of the last digit of its coordinates. */
const ROUNDINGS = 64;

/**
 * What lies between two marked events. Whether light goes from one to the other is told within the rounding of their coordinates.
 * c [m/s]. docs/physics.md §5.7.
 */
export function compareMarks(a: EventMark, b: EventMark, c: number): MarkDifference {
  const offset = sub(b.position, a.position);
  const X = fourVector(c * (b.time - a.time), offset);
  const between = interval([0, 0, 0, 0], X);
  return {
    dt: b.time - a.time,
    distance: distance(a.position, b.position),
    dOwn: b.ownTime - a.ownTime,
    dTau: a.thing === b.thing ? b.properTime - a.properTime : undefined,
    interval: between,
    separateness: separateness(X, between, ROUNDINGS * Number.EPSILON * (extent(a, c) + extent(b, c))),
    dtObserver: boost(X, b.u)[0] / c,
  };
}

/** `error`: of the coordinates of X [m]; Δs² is a product of two factors of that error. */
function separateness([ct, ...x]: FourVector, between: number, error: number): Separateness {
  const reach = Math.abs(ct) + Math.hypot(...x);
  if (reach <= error) return 'same';
  if (Math.abs(between) <= error * reach) return 'lightlike';
  return between < 0 ? 'timelike' : 'spacelike';
}

/** The size of the numbers that say where a mark is [m]. */
const extent = ({ time, position }: EventMark, c: number): number => c * Math.abs(time) + Math.hypot(...position);

const COLUMNS = 'name,thing,world time [s],x [m],y [m],z [m],its clock [s],own clock [s],vx [c],vy [c],vz [c]';

/** Marked events as a table of comma-separated values, in the words of programs; the last columns are the observer's velocity. */
export const marksCsv = (marks: readonly EventMark[]): string =>
  [COLUMNS, ...marks.map(rowOf)].map((line) => `${line}\n`).join('');

function rowOf({ name, thing = '', time, position, properTime, ownTime, u }: EventMark): string {
  return [quoted(name), quoted(thing), time, ...position, properTime, ownTime, ...velocity(u)].join();
}

/** RFC 4180, §2.6. */
const quoted = (text: string): string => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
