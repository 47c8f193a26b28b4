import { type FlightArc, flyArcs } from '../../flight/arc.ts';
import { boostOf } from '../../flight/boost.ts';
import { type FlightState, observerOf } from '../../flight/flightState.ts';
import type { FlightLeg, FlightRecording } from '../../flight/recording/recording.ts';
import { planTrip } from '../../flight/trip.ts';
import type { FlightPlan } from '../../lessons/flightPlan.ts';
import { add } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';

/** A plan, flown from an event: a leg for each part, turns between them are at once. c [m/s]. */
export function plannedFlight(plan: FlightPlan, start: FlightState, c: number): FlightRecording {
  const conditions = { c, lock: 'free', playing: true } as const;
  const legs: FlightLeg[] = [];
  let state = start;
  for (const part of plan) {
    const begin = { ...state, velocity: boostOf(part.kind === 'coast' ? properVelocity(part.beta) : [0, 0, 0]) };
    const arcs: readonly FlightArc[] =
      part.kind === 'coast'
        ? [{ dTau: part.lasts }]
        : planTrip(begin, add(observerOf(begin).position, part.by), { c, acceleration: part.acceleration, limit: 300 });
    legs.push({ conditions, start: begin, arcs });
    state = flyArcs(begin, arcs, conditions);
  }
  return { legs };
}
