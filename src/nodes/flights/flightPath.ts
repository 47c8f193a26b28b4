import { type FilmClock, filmClock } from '../../flight/recording/filmClock.ts';
import type { FlightPlayback } from '../../flight/recording/playback.ts';
import type { FlightRecording } from '../../flight/recording/recording.ts';
import type { FrameSpacing } from '../../flight/spacing.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { Lens } from '../../scene/view/lenses/lenses.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { flightViewPoint } from './flightViewPoint.ts';

/** The observer of a flight at a time of the pilot's [s]. */
export const flightPath =
  (playback: FlightPlayback, lens: Lens) =>
  (time: number): ViewPoint =>
    flightViewPoint(playback.stateAt(time), playback.legAt(time).conditions, lens);

/** The clock of a film of a flight. Throws where it is the world's, and that stands still or goes back. */
export function filmClockOf(playback: FlightPlayback, spacing: FrameSpacing): FilmClock {
  const clock = filmClock(playback, spacing);
  if (clock) return clock;
  throw new MessageError(
    msg`world time stands still or goes back in the flight, so that frames cannot follow it; let them follow the pilot's time`,
  );
}

/** Throws if a flight was flown at another speed of light [m/s] than a picture's. */
export function assertFlownAt(flight: FlightRecording, c: number): void {
  const flown = flightSpeedOfLight(flight);
  if (flown === c) return;
  throw new MessageError(
    msg`the flight was flown at ${flown} m/s, and light has ${c} m/s now; set it back to that for the film`,
  );
}

/** The speed of light of a flight [m/s]. Throws where its legs have different ones: a film has one. */
export function flightSpeedOfLight({ legs }: FlightRecording): number {
  const { c } = legs[0]!.conditions;
  const other = legs.findIndex(({ conditions }) => conditions.c !== c);
  if (other > 0) {
    const there = legs[other]!.conditions.c;
    throw new MessageError(
      msg`leg ${other + 1} flies at c = ${there} m/s, those before at ${c} m/s; a film has one speed of light: cut the flight there`,
    );
  }
  return c;
}
