import { type FlightConditions, seenVelocity } from '../../flight/arc.ts';
import { type FlightState, observerOf, pictureVelocity } from '../../flight/flightState.ts';
import type { Lens } from '../../scene/view/lenses/lenses.ts';
import type { ViewPoint } from '../../scene/view/view.ts';

/** What an observer in flight sees from. */
export function flightViewPoint(state: FlightState, { lock }: Pick<FlightConditions, 'lock'>, lens: Lens): ViewPoint {
  const { t, position, orientation } = observerOf(state);
  return { t, position, orientation, u: seenVelocity(lock, pictureVelocity(state.velocity)), lens };
}
