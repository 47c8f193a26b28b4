import { cross, length } from '../../math/vec3.ts';
import type { FlightArc, FlightConditions } from '../arc.ts';
import type { FlightState } from '../flightState.ts';
import type { FlightLeg, FlightRecording } from './recording.ts';

/** A leg that is still flown. */
interface OpenLeg extends FlightLeg {
  readonly arcs: FlightArc[];
  /** The state after its arcs. */
  end: FlightState;
}

/** Most arcs of a recording: more than two hours at 120 a second. */
export const MAX_ARCS = 1_000_000;

/** Writes down what is flown. Whatever else happens to the state begins a new leg. */
export class FlightRecorder {
  private readonly legs: OpenLeg[] = [];
  private count = 0;

  /** Whether it has no room for more. */
  get isFull(): boolean {
    return this.count >= MAX_ARCS;
  }

  /** Arcs from one state to another. Where `before` is not the last `after`, the observer was put elsewhere. */
  add(before: FlightState, arcs: readonly FlightArc[], conditions: FlightConditions, after: FlightState): void {
    let leg = this.legs.at(-1);
    if (!leg || leg.end !== before || !sameConditions(leg.conditions, conditions)) {
      const { c, lock, playing } = conditions;
      leg = { conditions: { c, lock, playing }, start: before, arcs: [], end: before };
      this.legs.push(leg);
    }
    for (const [i, arc] of arcs.entries()) {
      const last = leg.arcs.at(-1);
      if (i === 0 && last && goesOn(last, arc, before)) leg.arcs.splice(-1, 1, joined(last, arc));
      else {
        leg.arcs.push(arc);
        this.count++;
      }
    }
    leg.end = after;
  }

  recording(): FlightRecording {
    const flown = this.legs.filter(({ arcs }) => arcs.length > 0);
    return { legs: flown.map(({ conditions, start, arcs }) => ({ conditions, start, arcs: [...arcs] })) };
  }
}

const sameConditions = (a: FlightConditions, b: FlightConditions): boolean =>
  a.c === b.c && a.lock === b.lock && a.playing === b.playing;

/**
 * Whether an arc is nothing but more of the last: no turn in either, and the same push along the motion. A push across it, constant in these
 * axes, would not be constant for gyroscopes.
 */
function goesOn(last: FlightArc, { orientation, push }: FlightArc, { velocity }: FlightState): boolean {
  if (orientation || last.orientation || last.reached) return false;
  if (!last.push || !push) return last.push === push;
  const same = push.direction.every((x, k) => x === last.push?.direction[k]);
  return same && push.size === last.push.size && length(cross(push.direction, velocity.direction)) === 0;
}

const joined = (last: FlightArc, { dTau, reached }: FlightArc): FlightArc => ({
  ...last,
  dTau: last.dTau + dTau,
  ...(reached && { reached }),
});
