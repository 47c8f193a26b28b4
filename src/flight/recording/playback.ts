import { slerp } from '../../math/quat.ts';
import { brent } from '../../math/roots.ts';
import { flyArc } from '../arc.ts';
import type { FlightState } from '../flightState.ts';
import type { FlightLeg, FlightRecording } from './recording.ts';

/** A state is kept for every so many arcs; the others follow from it. */
const STRIDE = 64;

/** Arcs of one leg, with a known state at their beginning. */
interface Stretch {
  readonly leg: FlightLeg;
  /** Arcs `first` … `last − 1` of the leg. */
  readonly first: number;
  readonly last: number;
  readonly state: FlightState;
  /** The pilot's time [s] at its beginning and end. */
  readonly from: number;
  readonly to: number;
  /** World time [s] at its end. */
  readonly worldTo: number;
}

/**
 * A recording, flown again: the state at each of the pilot's times, which is proper time where the lock is `free` and world time
 * runs. At the ends of arcs it is as it was; within an arc the ship turns evenly, for a film of any number of frames a second.
 */
export class FlightPlayback {
  /** Of all of it, in the pilot's time [s]. */
  readonly duration: number;
  private readonly stretches: readonly Stretch[];

  /** At least one leg. */
  constructor({ legs }: FlightRecording) {
    const stretches: Stretch[] = [];
    let from = 0;
    for (const leg of legs) {
      let state = leg.start;
      for (let first = 0; first < leg.arcs.length; first += STRIDE) {
        const last = Math.min(leg.arcs.length, first + STRIDE);
        const begin = { leg, first, last, state, from };
        for (let i = first; i < last; i++) {
          from += leg.arcs[i]!.dTau;
          state = flyArc(state, leg.arcs[i]!, leg.conditions);
        }
        stretches.push({ ...begin, to: from, worldTo: state.t.value });
      }
    }
    this.duration = from;
    this.stretches = stretches;
  }

  /** The leg at a time of the pilot's [s], from 0 to `duration`. Where two meet it is the later. */
  legAt(time: number): FlightLeg {
    return this.stretchAt(time).leg;
  }

  /** The state at a time of the pilot's [s]. */
  stateAt(time: number): FlightState {
    const { leg, first, last, state, from } = this.stretchAt(time);
    let [now, left] = [state, time - from];
    for (let i = first; i < last; i++) {
      const arc = leg.arcs[i]!;
      if (arc.dTau > left) return within(now, leg, i, Math.max(0, left));
      now = flyArc(now, arc, leg.conditions);
      left -= arc.dTau;
    }
    return now;
  }

  /** The pilot's time [s] at a world time t [s] of the flight. Where it jumps, the first that is not earlier. */
  timeAtWorld(t: number): number {
    const { from, to } = this.stretches[this.placeOf(({ worldTo }) => worldTo >= t)]!;
    const late = (time: number): number => this.stateAt(Math.min(time, this.duration)).t.value - t;
    if (late(from) >= 0) return from;
    return brent(late, from, to * (1 - Number.EPSILON));
  }

  /** World times [s] of beginning and end; undefined where world time stands still or goes back, so that a film cannot follow it. */
  worldSpan(): readonly [from: number, to: number] | undefined {
    let t = Number.NEGATIVE_INFINITY;
    for (const { leg, state, worldTo } of this.stretches) {
      if (!leg.conditions.playing || state.t.value < t) return undefined;
      t = worldTo;
    }
    return [this.stretches[0]!.state.t.value, t];
  }

  private stretchAt(time: number): Stretch {
    return this.stretches[this.placeOf(({ to }) => to > time)]!;
  }

  /** The first stretch with a property that all after it have; the last, if none has. */
  private placeOf(has: (stretch: Stretch) => boolean): number {
    let [low, high] = [0, this.stretches.length - 1];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (has(this.stretches[middle]!)) high = middle;
      else low = middle + 1;
    }
    return low;
  }
}

/** The state after the part `left` [s] of an arc. */
function within(state: FlightState, { arcs, conditions }: FlightLeg, i: number, left: number): FlightState {
  const arc = arcs[i]!;
  if (left === 0) return state;
  const turned = arc.orientation && slerp(state.orientation, arc.orientation, left / arc.dTau);
  return flyArc(state, turned ? { ...arc, orientation: turned } : arc, conditions, left);
}
