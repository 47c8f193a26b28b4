import { type FlightArc, turnedFirst } from './arc.ts';
import type { FlightMode, FlightMoment } from './modes/flightMode.ts';

/** What a ship flies in a moment: the mode turns it, and then pushes. */
export function arcsOf(mode: FlightMode, moment: FlightMoment): readonly FlightArc[] {
  const { state } = moment;
  const orientation = mode.orientation(moment);
  if (orientation === state.orientation) return mode.arcs(moment);
  return turnedFirst(mode.arcs({ ...moment, state: { ...state, orientation } }), orientation);
}
