import { AdaptiveSteps } from './adaptiveSteps.ts';
import { type ConservedQuantities, conservedQuantities } from './energy.ts';
import { assertFinite, Integrator } from './integrator.ts';
import { type IntegrationMethod, StepFailure, type StepFailureReason } from './methods/method.ts';
import { maxAngularFrequency } from './stability.ts';
import { copyState, type State, type System } from './system.ts';

/** What is to be computed. */
export interface RunOptions {
  readonly system: System;
  /** Not changed. */
  readonly start: State;
  /** Of a run that goes on: when the whole began [s], and which of its frames `start` is. Its times are then those of the whole, to the last digit. */
  readonly since?: { readonly t: number; readonly frames: number };
  readonly method: IntegrationMethod;
  /** From `start.t` on [s]. */
  readonly duration: number;
  /** How often the state is given [s]. */
  readonly every: number;
  /** The longest step [s]; absent: a tenth of what an explicit method can take at most. A whole number of equal steps goes into `every`. */
  readonly step?: number;
  /**
   * Steps follow what they get wrong: of each second, the errors of all steps add up to no more than this, in the place of any point [m] and in its velocity [m/s] (adaptiveSteps.ts). `step` is then
   * the longest; absent: a frame, or what an explicit method can take.
   */
  readonly tolerance?: number;
}

/** What a run gives, from time to time. */
export interface SimulationFrame {
  readonly state: State;
  readonly quantities: ConservedQuantities;
  /** Steps taken from the start. */
  readonly steps: number;
}

/** Why a run ended before its time. */
export interface EarlyStop {
  readonly reason: StepFailureReason;
  /** [s] */
  readonly t: number;
  readonly message: string;
  /** That it happened to, where it is one. */
  readonly point?: number;
}

/** Share of 2/ω that steps take where nobody says how long they are to be. */
const DEFAULT_STEP_FRACTION = 0.1;
/** Share of 2/ω that steps which follow their error take at most, where 2/ω bounds them. */
const MAX_STEP_FRACTION = 0.9;
/** Where nothing swings, and nobody says how long steps are to be, so many go into a frame. */
const DEFAULT_STEPS_PER_FRAME = 10;
const MAX_STEPS = 1e9;
/** What may be gained of the energy where steps are longer than the stability bound, over the kinetic energy: more is not a swing. */
export const MAX_ENERGY_GAIN = 0.5;

export interface StepSchedule {
  /** The longest that there are [s]. */
  readonly h: number;
  /** So many, or more where they adapt. */
  readonly perFrame: number;
  /** Whether h < 2/ω, where the method asks for that: else what is small may grow in every step. */
  readonly stable: boolean;
}

/** The steps that an order is computed with. */
export function stepSchedule(order: RunOptions): StepSchedule {
  const { system, method, every } = order;
  const omega = maxAngularFrequency(system);
  const perFrame = Math.max(1, Math.ceil(every / maxStepLength(order, omega) - 1e-9));
  const h = every / perFrame;
  return { h, perFrame, stable: !method.conditionallyStable || h * omega < 2 };
}

function maxStepLength({ method, every, step, tolerance }: RunOptions, omega: number): number {
  if (tolerance === undefined)
    return step ?? (omega > 0 ? (DEFAULT_STEP_FRACTION * 2) / omega : every / DEFAULT_STEPS_PER_FRAME);
  const bound = method.conditionallyStable && omega > 0 ? (MAX_STEP_FRACTION * 2) / omega : every;
  return Math.min(step ?? every, bound);
}

/**
 * Runs a system from frame to frame; the first is the start. It returns why it ended where it could not go on: the last frame given is good. Whoever asks decides when
 * it goes on, so that it can be cancelled, and taken up again from any frame's state.
 */
export function* integrate(order: RunOptions): Generator<SimulationFrame, EarlyStop | undefined> {
  const course = new FrameBuilder(order);
  const advance = advancer(order, course.steps);
  const state = copyState(order.start);
  yield course.start();
  while (!course.isDone) {
    let frame: SimulationFrame;
    try {
      frame = course.next(state, advance(state));
    } catch (error) {
      return earlyStopFor(error, state.t);
    }
    yield frame;
  }
  return undefined;
}

/** The frames of a run, whoever computes them. */
export class FrameBuilder {
  readonly steps: StepSchedule;
  private readonly order: RunOptions;
  private readonly frames: number;
  private readonly first: ConservedQuantities;
  private frame = 0;
  private taken = 0;

  constructor(order: RunOptions) {
    this.order = order;
    this.steps = stepSchedule(order);
    this.frames = Math.round(order.duration / order.every);
    const all = this.frames * this.steps.perFrame;
    if (!(all <= MAX_STEPS)) throw new RangeError(`${all} steps are too many`);
    this.first = conservedQuantities(order.system, order.start);
  }

  get isDone(): boolean {
    return this.frame === this.frames;
  }

  start = (): SimulationFrame => ({ state: copyState(this.order.start), quantities: this.first, steps: 0 });

  /** The next frame, of a state that was taken there in so many steps. Throws a StepFailure where what came is not to be trusted. */
  next(state: State, steps: number): SimulationFrame {
    const { order, first } = this;
    assertFinite(state);
    const now = conservedQuantities(order.system, state);
    assertEnergyBounded(order, this.steps, first, now);
    this.taken += steps;
    this.frame++;
    // Sums of many steps drift away from what a clock shows.
    const { t, frames } = order.since ?? { t: order.start.t, frames: 0 };
    state.t = t + (frames + this.frame) * order.every;
    return { state: copyState(state), quantities: now, steps: this.taken };
  }
}

/** Why a run ends at t, by what was thrown; that which is no StepFailure is thrown on. */
export function earlyStopFor(error: unknown, t: number): EarlyStop {
  if (!(error instanceof StepFailure)) throw error;
  const { reason, message, point } = error;
  return { reason, t, message, ...(point !== undefined && { point }) };
}

/** Takes a state one frame further, and tells in how many steps. */
function advancer(order: RunOptions, { h, perFrame }: StepSchedule): (state: State) => number {
  const { system, method, every, tolerance } = order;
  const mover = new Integrator(system, method);
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
function assertEnergyBounded(
  order: RunOptions,
  { h, stable }: StepSchedule,
  first: ConservedQuantities,
  now: ConservedQuantities,
): void {
  if (stable || now.total - first.total <= MAX_ENERGY_GAIN * now.kinetic) return;
  const bound = (2 / maxAngularFrequency(order.system)).toPrecision(3);
  const gain = (now.total - first.total).toPrecision(3);
  const message = `the energy has grown by ${gain} J: steps of ${h.toPrecision(3)} s are longer than ${order.method.id} can take here, ${bound} s; take shorter ones`;
  throw new StepFailure('unstable', message);
}
