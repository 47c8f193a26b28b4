import type { FlightConditions } from '../../flight/arc.ts';
import { type FlightState, observerOf, pictureVelocity } from '../../flight/flightState.ts';
import { ZERO } from '../../math/vec3.ts';
import type { Lens } from '../../scene/view/lens.ts';
import type { ViewPoint } from '../../scene/view/view.ts';

/** What an observer in flight sees from. With the lock `fly` the picture is that of an observer at rest. */
export function flightViewPoint(state: FlightState, { lock }: Pick<FlightConditions, 'lock'>, lens: Lens): ViewPoint {
  const { t, position, orientation } = observerOf(state);
  return { t, position, orientation, u: lock === 'fly' ? ZERO : pictureVelocity(state.velocity), lens };
}
