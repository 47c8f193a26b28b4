import { AdaptiveSteps } from './adaptive.ts';
import { type Ledger, ledger } from './energy.ts';
import { type Failure, type Method, StepFailure } from './methods/method.ts';
import { Mover, refuseInfinite } from './mover.ts';
import { fastestOscillation } from './stability.ts';
import { copyOf, type State, type System } from './system.ts';

/** What is to be computed. */
export interface Order {
  readonly system: System;
  /** Not changed. */
  readonly start: State;
  /** Of a run that goes on: when the whole began [s], and which of its frames `start` is. Its times are then those of the whole, to the last digit. */
  readonly since?: { readonly t: number; readonly frames: number };
  readonly method: Method;
  /** From `start.t` on [s]. */
  readonly duration: number;
  /** How often the state is given [s]. */
  readonly every: number;
  /** The longest step [s]; absent: a tenth of what an explicit method can take at most. A whole number of equal steps goes into `every`. */
  readonly step?: number;
  /**
   * Steps follow what they get wrong: of each second, the errors of all steps add up to no more than this, in the place of any point [m] and in its velocity [m/s] (adaptive.ts). `step` is then
   * the longest; absent: a frame, or what an explicit method can take.
   */
  readonly tolerance?: number;
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
  /** That it happened to, where it is one. */
  readonly point?: number;
}

/** Share of 2/ω that steps take where nobody says how long they are to be. */
const CAREFUL = 0.1;
/** Share of 2/ω that steps which follow their error take at most, where 2/ω bounds them. */
const BOUNDED = 0.9;
/** Where nothing swings, and nobody says how long steps are to be, so many go into a frame. */
const FREE_STEPS = 10;
const MOST_STEPS = 1e9;
/** What may be gained of the energy where steps are longer than the stability bound, over the kinetic energy: more is not a swing. */
export const SWING = 0.5;

export interface Steps {
  /** The longest that there are [s]. */
  readonly h: number;
  /** So many, or more where they adapt. */
  readonly perFrame: number;
  /** Whether h < 2/ω, where the method asks for that: else what is small may grow in every step. */
  readonly stable: boolean;
}

/** The steps that an order is computed with. */
export function stepsOf(order: Order): Steps {
  const { system, method, every } = order;
  const omega = fastestOscillation(system);
  const perFrame = Math.max(1, Math.ceil(every / longest(order, omega) - 1e-9));
  const h = every / perFrame;
  return { h, perFrame, stable: !method.bounded || h * omega < 2 };
}

function longest({ method, every, step, tolerance }: Order, omega: number): number {
  if (tolerance === undefined) return step ?? (omega > 0 ? (CAREFUL * 2) / omega : every / FREE_STEPS);
  const bound = method.bounded && omega > 0 ? (BOUNDED * 2) / omega : every;
  return Math.min(step ?? every, bound);
}

/**
 * Runs a system from frame to frame; the first is the start. It returns why it ended where it could not go on: the last frame given is good. Whoever asks decides when
 * it goes on, so that it can be cancelled, and taken up again from any frame's state.
 */
export function* run(order: Order): Generator<Frame, Stop | undefined> {
  const course = new Course(order);
  const advance = advancer(order, course.steps);
  const state = copyOf(order.start);
  yield course.start();
  while (!course.ended) {
    let frame: Frame;
    try {
      frame = course.next(state, advance(state));
    } catch (error) {
      return stopOf(error, state.t);
    }
    yield frame;
  }
  return undefined;
}

/** The frames of a run, whoever computes them. */
export class Course {
  readonly steps: Steps;
  private readonly order: Order;
  private readonly frames: number;
  private readonly first: Ledger;
  private frame = 0;
  private taken = 0;

  constructor(order: Order) {
    this.order = order;
    this.steps = stepsOf(order);
    this.frames = Math.round(order.duration / order.every);
    const all = this.frames * this.steps.perFrame;
    if (!(all <= MOST_STEPS)) throw new RangeError(`${all} steps are too many`);
    this.first = ledger(order.system, order.start);
  }

  get ended(): boolean {
    return this.frame === this.frames;
  }

  start = (): Frame => ({ state: copyOf(this.order.start), ledger: this.first, steps: 0 });

  /** The next frame, of a state that was taken there in so many steps. Throws a StepFailure where what came is not to be trusted. */
  next(state: State, steps: number): Frame {
    const { order, first } = this;
    refuseInfinite(state);
    const now = ledger(order.system, state);
    refuseGrowth(order, this.steps, first, now);
    this.taken += steps;
    this.frame++;
    // Sums of many steps drift away from what a clock shows.
    const { t, frames } = order.since ?? { t: order.start.t, frames: 0 };
    state.t = t + (frames + this.frame) * order.every;
    return { state: copyOf(state), ledger: now, steps: this.taken };
  }
}

/** Why a run ends at t, by what was thrown; that which is no StepFailure is thrown on. */
export function stopOf(error: unknown, t: number): Stop {
  if (!(error instanceof StepFailure)) throw error;
  const { reason, message, point } = error;
  return { reason, t, message, ...(point !== undefined && { point }) };
}

/** Takes a state one frame further, and tells in how many steps. */
function advancer(order: Order, { h, perFrame }: Steps): (state: State) => number {
  const { system, method, every, tolerance } = order;
  const mover = new Mover(system, method);
  if (tolerance !== undefined) {
    const adaptive = new AdaptiveSteps(mover, system, { order: method.order, tolerance, longest: h });
    return (state) => adaptive.advance(state, every);
  }
  return (state) => {
    for (let i = 0; i < perFrame; i++) mover.step(state, h);
    return perFrame;
  };
}

/** Where steps are longer than the stability bound, energy that comes from nowhere is the end. */
function refuseGrowth(order: Order, { h, stable }: Steps, first: Ledger, now: Ledger): void {
  if (stable || now.total - first.total <= SWING * now.kinetic) return;
  const bound = (2 / fastestOscillation(order.system)).toPrecision(3);
  const gain = (now.total - first.total).toPrecision(3);
  const message = `the energy has grown by ${gain} J: steps of ${h.toPrecision(3)} s are longer than ${order.method.id} can take here, ${bound} s; take shorter ones`;
  throw new StepFailure('unstable', message);
}
