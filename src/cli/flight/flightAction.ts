import { type FlightArc, flyArc, flyArcs } from '../../flight/arc.ts';
import { MAX_RAPIDITY } from '../../flight/controls.ts';
import { type FlightState, flightOf, observerOf } from '../../flight/flightState.ts';
import { cutFlight, spliceFlights } from '../../flight/recording/edit.ts';
import {
  type FlightLeg,
  type FlightRecording,
  legDuration,
  recordingDuration,
} from '../../flight/recording/recording.ts';
import { planTrip } from '../../flight/trip.ts';
import { length, sub, ZERO } from '../../math/vec3.ts';
import { inLines, type Message, msg } from '../../messages/message.ts';
import { lookAtOrientation } from '../../scene/view/camera.ts';
import { readFlightFile, writeFlightFile } from '../files/flightFiles.ts';
import { checkWritable } from '../files/outputFile.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import { localized } from '../terminal/language.ts';
import type { CutFlags, TripFlags } from './flightFlags.ts';

export function trip(flags: TripFlags): void {
  const { output, from, to, acceleration, c, start, maxSpeed } = flags;
  checkWritable(output);
  const way = sub(to, from);
  if (length(way) === 0) throw usageError(msg`--to is where the trip begins: there is nothing to fly`);
  const orientation = lookAtOrientation(way, [0, 1, 0]);
  const rules = { c, acceleration, limit: maxSpeed === undefined ? MAX_RAPIDITY : Math.atanh(maxSpeed) };
  const conditions = { c, lock: 'free', playing: true } as const;
  const begin = flightOf({ t: start, position: from, u: ZERO, orientation, properTime: 0 });
  const there = planTrip(begin, to, rules);
  const back: readonly FlightArc[] = flags.return ? planTrip(flyArcs(begin, there, conditions), from, rules) : [];
  const recording: FlightRecording = { legs: [{ conditions, start: begin, arcs: [...there, ...back] }] };
  writeFlightFile(output, recording);
  tell(recording, flags);
}

export const inspectFlight = (path: string, flags: { readonly json?: boolean }): void =>
  tell(readFlightFile(path), flags);

export function cut(path: string, { output, from = 0, to }: CutFlags): void {
  checkWritable(output);
  const recording = readFlightFile(path);
  const duration = recordingDuration(recording);
  const end = Math.min(to ?? duration, duration);
  if (from >= end)
    throw usageError(msg`--from ${from}, --to ${end}: nothing lies between; ${path} lasts from 0 to ${duration} s`);
  writeFlightFile(output, cutFlight(recording, from, end));
}

export function splice(paths: readonly string[], { output }: { readonly output: string }): void {
  checkWritable(output);
  writeFlightFile(output, spliceFlights(paths.map(readFlightFile)));
}

const tell = (recording: FlightRecording, { json }: { readonly json?: boolean }): void => {
  const summary = summarize(recording);
  console.log(json ? toJson(summary) : describe(summary));
};

type FlightSummary = ReturnType<typeof summarize>;

function summarize(recording: FlightRecording) {
  return {
    pilotTime: recordingDuration(recording),
    legs: recording.legs.map(summarizeLeg),
  };
}

function summarizeLeg(leg: FlightLeg) {
  const { conditions, start, arcs } = leg;
  const { end, fastest } = flown(leg);
  const [first, last] = [observerOf(start), observerOf(end)];
  return {
    speedOfLight: conditions.c,
    lock: conditions.lock,
    worldTimeRuns: conditions.playing,
    arcs: arcs.length,
    pilotTime: legDuration(leg),
    properTime: last.properTime - first.properTime,
    worldTime: last.t - first.t,
    from: first.position,
    to: last.position,
    rapidity: fastest,
    gamma: Math.cosh(fastest),
  };
}

/** Where a leg ends, and the greatest rapidity at its beginning or after an arc: between them it may dip, but not rise above both. */
function flown({ conditions, start, arcs }: FlightLeg): { readonly end: FlightState; readonly fastest: number } {
  let [end, fastest] = [start, start.velocity.rapidity];
  for (const arc of arcs) {
    end = flyArc(end, arc, conditions);
    fastest = Math.max(fastest, end.velocity.rapidity);
  }
  return { end, fastest };
}

const describe = ({ pilotTime, legs }: FlightSummary): string =>
  localized(
    inLines([
      msg`${time(pilotTime)} of the pilot's time, legs: ${legs.length}`,
      ...legs.map(
        ({ speedOfLight, lock, worldTimeRuns, properTime, worldTime, gamma, from, to }, i): Message =>
          msg`  ${i + 1}: own clock ${time(properTime)}, world ${time(worldTime)}, greatest γ ${digits(gamma)}, from ${place(from)} to ${place(to)} m, c = ${String(speedOfLight)} m/s${lock === 'free' ? '' : msg`, lock ${lock}`}${worldTimeRuns ? '' : msg`, world time paused`}`,
      ),
    ]),
  );

const YEAR = 31_557_600;
const digits = (x: number): string => String(Number(x.toPrecision(6)));
const place = (position: readonly number[]): string => `(${position.map(digits).join(', ')})`;
/** With years too, where there are some. */
const time = (seconds: number): Message =>
  seconds < YEAR / 10 ? msg`${digits(seconds)} s` : msg`${digits(seconds)} s (${digits(seconds / YEAR)} years)`;
