import { type Ledger, ledger } from './energy.ts';
import { type Failure, type Method, StepFailure, type Stepper } from './methods/method.ts';
import { fastestOscillation } from './stability.ts';
import { assign, copyOf, type State, type System } from './system.ts';

/** What is to be computed. */
export interface Order {
  readonly system: System;
  /** Not changed. */
  readonly start: State;
  readonly method: Method;
  /** From `start.t` on [s]. */
  readonly duration: number;
  /** How often the state is given [s]. */
  readonly every: number;
  /** The longest step [s]; absent: a tenth of what an explicit method can take at most. A whole number of equal steps goes into `every`. */
  readonly step?: number;
}

/** What a run gives, from time to time. */
export interface Frame {
  readonly state: State;
  readonly ledger: Ledger;
  /** Steps taken from the start. */
  readonly steps: number;
}

/** Why a run ended before its time. */
export interface Stop {
  readonly reason: Failure;
  /** [s] */
  readonly t: number;
  readonly message: string;
}

/** Share of 2/ω that steps take where nobody says how long they are to be. */
const CAREFUL = 0.1;
/** Where nothing swings, and nobody says how long steps are to be, so many go into a frame. */
const FREE_STEPS = 10;
const MOST_STEPS = 1e9;

export interface Steps {
  /** [s] */
  readonly h: number;
  readonly perFrame: number;
  /** Whether h < 2/ω, where the method asks for that: else what is small may grow in every step. */
  readonly stable: boolean;
}

/** The steps that an order is computed with. */
export function stepsOf({ system, method, every, step }: Order): Steps {
  const omega = fastestOscillation(system);
  const careful = omega > 0 ? (CAREFUL * 2) / omega : every / FREE_STEPS;
  const perFrame = Math.max(1, Math.ceil(every / (step ?? careful) - 1e-9));
  const h = every / perFrame;
  return { h, perFrame, stable: !method.bounded || h * omega < 2 };
}

/**
 * Runs a system from frame to frame; the first is the start. It returns why it ended where it could not go on: the last frame given is good. Whoever asks decides when
 * it goes on, so that it can be cancelled, and taken up again from any frame's state.
 */
export function* run(order: Order): Generator<Frame, Stop | undefined> {
  const { system, start, method, duration, every } = order;
  const { h, perFrame } = stepsOf(order);
  const frames = Math.round(duration / every);
  if (!(frames * perFrame <= MOST_STEPS)) throw new RangeError(`${frames * perFrame} steps are too many`);
  const stepper = method.begin(system);
  const state = copyOf(start);
  yield { state: copyOf(state), ledger: ledger(system, state), steps: 0 };
  for (let frame = 1; frame <= frames; frame++) {
    const before = copyOf(state);
    try {
      for (let i = 0; i < perFrame; i++) stepWithDrag(stepper, system, state, h);
      // Sums of many steps drift away from what a clock shows.
      state.t = start.t + frame * every;
      refuseInfinite(state);
    } catch (error) {
      if (!(error instanceof StepFailure)) throw error;
      const t = state.t;
      assign(state, before);
      return { reason: error.reason, t, message: error.message };
    }
    yield { state: copyOf(state), ledger: ledger(system, state), steps: frame * perFrame };
  }
  return undefined;
}

/** Air before and after, half of it each, so that a step stays the same when it is run backwards. */
function stepWithDrag(stepper: Stepper, { drag }: System, state: State, h: number): void {
  slowDown(state, (drag * h) / 2);
  stepper.step(state, h);
  slowDown(state, (drag * h) / 2);
}

function slowDown({ p }: State, much: number): void {
  if (much === 0) return;
  const share = Math.exp(-much);
  for (let j = 0; j < p.length; j++) p[j] *= share;
}

function refuseInfinite({ x, p }: State): void {
  const odd = x.findIndex((value, j) => !Number.isFinite(value) || !Number.isFinite(p[j]));
  if (odd >= 0) {
    const point = Math.floor(odd / 3);
    throw new StepFailure('infinite', `point ${point} has no place any more; take a smaller step`, point);
  }
}
