import type { FlightArc, FlightConditions } from '../../flight/arc.ts';
import type { FlightState } from '../../flight/flightState.ts';
import type { FlightMoment } from '../../flight/modes/flightMode.ts';
import type { FlightLeg } from '../../flight/recording/recording.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';

/** A moment of a replay. */
export interface ReplayedMoment {
  readonly state: FlightState;
  readonly leg: FlightLeg;
}

/** Who flies in other modes than the first, records and replays; loaded with the flight deck. */
export interface Pilot {
  /** What is flown in a moment of which the rules are the page's. */
  readonly arcs: (moment: FlightMoment, picture: PictureSpec) => readonly FlightArc[];
  /** Told of all arcs. */
  readonly flown: (
    before: FlightState,
    arcs: readonly FlightArc[],
    conditions: FlightConditions,
    after: FlightState,
  ) => void;
  /** While a recording is replayed, its moment after `dt` [s]. `busy`: whether the user flies, which ends it. */
  readonly replayed: (dt: number, busy: boolean) => ReplayedMoment | undefined;
}
