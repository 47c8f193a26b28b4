import type { FlightArc, FlightConditions } from '../arc.ts';
import type { FlightState } from '../flightState.ts';
import { durationOf } from '../trip.ts';

/** A part of a flight without a jump, flown under the same conditions. */
export interface FlightLeg {
  readonly conditions: FlightConditions;
  readonly start: FlightState;
  readonly arcs: readonly FlightArc[];
}

/** What was flown: legs one after another. Between them the observer may be put elsewhere, as by a cut of a film. */
export interface FlightRecording {
  readonly legs: readonly FlightLeg[];
}

/** The pilot's time of a leg, and of all legs [s]: proper time, where the lock is `free` and world time runs. */
export const legDuration = ({ arcs }: FlightLeg): number => durationOf(arcs);
export const recordingDuration = ({ legs }: FlightRecording): number =>
  legs.reduce((sum, leg) => sum + legDuration(leg), 0);
