import type { FlightPlayback } from '../../flight/recording/playback.ts';
import type { FlightRecording } from '../../flight/recording/recording.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { Lens } from '../../scene/view/lens.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { flightViewPoint } from './flightViewPoint.ts';

/** The observer of a flight at a time of the pilot's [s]. */
export const flightPath =
  (playback: FlightPlayback, lens: Lens) =>
  (time: number): ViewPoint =>
    flightViewPoint(playback.stateAt(time), playback.legAt(time).conditions, lens);

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
