import type { Quat } from '../../math/quat.ts';
import type { Message } from '../../messages/message.ts';
import type { FlightArc } from '../arc.ts';
import type { FlightControls, FlightRules } from '../controls.ts';
import type { FlightState } from '../flightState.ts';

/** A moment of a flight, in which something is asked of the ship. */
export interface FlightMoment {
  readonly state: FlightState;
  readonly controls: FlightControls;
  /** Proper time of the moment [s]. */
  readonly dt: number;
  readonly rules: FlightRules;
}

/** A way in which controls fly a ship. */
export interface FlightMode {
  readonly title: Message;
  readonly help: Message;
  /** The greatest proper acceleration with which it brakes [m/s²]. */
  readonly strength: (rules: FlightRules) => number;
  /** To which the ship turns at the beginning of a moment. */
  readonly orientation: (moment: FlightMoment) => Quat;
  /** What it flies in a moment, turned already. They take `dt` in all. */
  readonly arcs: (moment: FlightMoment) => readonly FlightArc[];
}
