import type { FlightConditions } from '../../flight/arc.ts';
import type { FlightState } from '../../flight/flightState.ts';
import type { FlightMoment } from '../../flight/modes/flightMode.ts';
import type { FlightLeg } from '../../flight/recording/recording.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';

/** A moment of a replay. */
export interface ReplayedMoment {
  readonly state: FlightState;
  readonly leg: FlightLeg;
}

/** Who flies in other modes than the first, minds walls, records and replays; loaded with the flight deck. */
export interface Pilot {
  /** The state after a moment of which the rules are the page's. */
  readonly fly: (moment: FlightMoment, conditions: FlightConditions, picture: PictureSpec) => FlightState;
  /** While a recording is replayed, its moment after `dt` [s]. `busy`: whether the user flies, which ends it. */
  readonly replayed: (dt: number, busy: boolean) => ReplayedMoment | undefined;
}
