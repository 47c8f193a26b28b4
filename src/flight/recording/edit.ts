import { rotate } from '../../math/quat.ts';
import { type FlightArc, flyArc } from '../arc.ts';
import { gyroscopeRotation } from '../boost.ts';
import type { FlightState } from '../flightState.ts';
import { FlightPlayback } from './playback.ts';
import { type FlightLeg, type FlightRecording, legDuration } from './recording.ts';

/** The part of a recording between two of the pilot's times [s]. */
export function cutFlight(recording: FlightRecording, from: number, to: number): FlightRecording {
  const playback = new FlightPlayback(recording);
  let begin = 0;
  const legs = recording.legs.flatMap((leg) => {
    const end = begin + legDuration(leg);
    const [first, last] = [Math.max(from, begin), Math.min(to, end)];
    const kept = first < last ? [cutLeg(leg, first - begin, last - begin, playback, begin)] : [];
    begin = end;
    return kept;
  });
  return { legs };
}

function cutLeg(leg: FlightLeg, from: number, to: number, playback: FlightPlayback, begin: number): FlightLeg {
  const arcs: FlightArc[] = [];
  let [time, state] = [0, leg.start];
  for (const arc of leg.arcs) {
    const [first, last] = [Math.max(from, time), Math.min(to, time + arc.dTau)];
    if (first < last) arcs.push(partOf(arc, state, first - time, last - time, leg.conditions.c));
    time += arc.dTau;
    state = flyArc(state, arc, leg.conditions);
  }
  return { ...leg, start: from === 0 ? leg.start : playback.stateAt(begin + from), arcs };
}

/** A part of an arc that begins at a state. A push that is constant for gyroscopes turns against axes that pure boosts carry. */
function partOf(arc: FlightArc, { velocity }: FlightState, from: number, to: number, c: number): FlightArc {
  const { reached, push, ...rest } = arc;
  const before = push && gyroscopeRotation(velocity, { direction: push.direction, rapidity: (push.size * from) / c });
  return {
    ...rest,
    dTau: to - from,
    ...(push &&
      before && { push: { ...push, direction: from === 0 ? push.direction : rotate(before, push.direction) } }),
    ...(reached && to === arc.dTau && { reached }),
  };
}

/** One recording after the other; where they do not meet, the observer is put elsewhere, as by a cut of a film. */
export const spliceFlights = (recordings: readonly FlightRecording[]): FlightRecording => ({
  legs: recordings.flatMap(({ legs }) => legs),
});
