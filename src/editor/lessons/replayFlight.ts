import { flyArcs } from '../../flight/arc.ts';
import type { FlightState } from '../../flight/flightState.ts';
import { velocityMode } from '../../flight/modes/velocity.ts';
import { FlightPlayback } from '../../flight/recording/playback.ts';
import type { FlightRecording } from '../../flight/recording/recording.ts';
import { arcsOf } from '../../flight/step.ts';
import type { ObserverController } from '../flight/observerController.ts';
import type { Pilot } from '../flight/pilot.ts';

/**
 * Flies a recording in real time of its pilot. It ends with the recording, when the user flies, or when the signal is aborted;
 * who was the pilot before is it again. `onEnd`: not called when aborted; with the last state, or without one if the user flies.
 */
export function replayFlight(
  recording: FlightRecording,
  controller: ObserverController,
  signal: AbortSignal,
  onEnd: (last?: FlightState) => void,
): void {
  const playback = new FlightPlayback(recording);
  const before = controller.pilot;
  let time = 0;
  const leave = (): void => {
    if (controller.pilot === pilot) controller.pilot = before;
  };
  const pilot: Pilot = {
    fly: (moment, conditions, picture) =>
      before?.fly(moment, conditions, picture) ?? flyArcs(moment.state, arcsOf(velocityMode, moment), conditions),
    replayed: (dt, busy) => {
      if (!busy && time < playback.duration) {
        time = Math.min(playback.duration, time + dt);
        return { state: playback.stateAt(time), leg: playback.legAt(time) };
      }
      leave();
      onEnd(busy ? undefined : playback.stateAt(playback.duration));
      return undefined;
    },
  };
  controller.pilot = pilot;
  signal.addEventListener('abort', leave);
}
