import { FlightPlayback } from '../../flight/recording/playback.ts';
import { msg } from '../../messages/message.ts';
import { filmClockOf, flightSpeedOfLight } from '../../nodes/flights/flightPath.ts';
import type { FrameTime } from '../../nodes/project/outputFiles.ts';
import { readFlightFile } from '../files/flightFiles.ts';
import { flagName } from '../flags/viewFlags.ts';
import { inputProblem, orRefuse, usageError } from '../terminal/exitCodes.ts';
import type { RenderFlags } from './renderFlags.ts';

/** A recorded flight, to be filmed. */
export interface FilmedFlight {
  readonly playback: FlightPlayback;
  /** [m/s] */
  readonly speedOfLight: number;
}

/** Flags that say where the observer is, which a flight says itself. */
const OBSERVER_FLAGS = ['camera', 'cameraPath', 'beta', 'position', 'lookAt', 'stayInPlace', 'vantage'] as const;

/** The flight that `--flight` names. Throws if other flags contradict it. */
export function filmedFlight(path: string, { c }: Pick<RenderFlags, 'c'>, given: ReadonlySet<string>): FilmedFlight {
  const contradicting = OBSERVER_FLAGS.find((name) => given.has(name));
  if (contradicting !== undefined) {
    const flag = flagName(contradicting);
    throw usageError(msg`--${flag} says where the observer is, and so does --flight: leave one of them out`);
  }
  const recording = readFlightFile(path);
  const speedOfLight = orRefuse(
    () => flightSpeedOfLight(recording),
    (problem) => inputProblem(msg`${path}: ${problem}`),
  );
  if (c !== undefined && c !== speedOfLight)
    throw usageError(msg`--c ${c}: ${path} was flown at ${speedOfLight} m/s; leave --c out, or fly it again`);
  return { playback: new FlightPlayback(recording), speedOfLight };
}

/** Frame n is at n/fps of the flight's own time [s], or of the world's, from its beginning: all of it, or the frames that are asked for. */
export function flightFrames(
  { playback }: FilmedFlight,
  { time, frames, output, spacing = 'proper' }: RenderFlags,
  fps: number,
): FrameTime[] {
  const clock = orRefuse(
    () => filmClockOf(playback, spacing),
    (problem) => usageError(msg`${`--spacing ${spacing}`}: ${problem}`),
  );
  const { duration } = clock;
  const inside = (t: number, flag: string): number => {
    if (t >= 0 && t <= duration * (1 + 1e-12)) return clock.pilotTime(Math.min(t, duration));
    throw usageError(msg`${flag}: the flight lasts from 0 to ${duration} s`);
  };
  if (!frames && !/#|\.(mp4|gif)$/i.test(output)) return [{ t: inside(time ?? 0, `--time ${time}`) }];
  const { first, last } = frames ?? { first: 0, last: Math.floor(duration * fps + 1e-9) };
  return Array.from({ length: last - first + 1 }, (_, i) => ({
    number: first + i,
    t: inside((first + i) / fps, `--frames ${first}:${last}`),
  }));
}
