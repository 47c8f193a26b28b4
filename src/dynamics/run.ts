import { type Message, msg } from '../messages/message.ts';
import { AdaptiveSteps } from './adaptiveSteps.ts';
import { type ConservedQuantities, conservedQuantities, MAX_ENERGY_GAIN } from './energy.ts';
import { assertFinite, Integrator } from './integrator.ts';
import { type IntegrationMethod, StepFailure, type StepFailureReason } from './methods/method.ts';
import { maxAngularFrequency } from './stability.ts';
import { assignState, copyState, momenta, type State, type System, SystemError } from './system.ts';
import { type TeamThreads, ThreadTeam, teamSize } from './threads/threadTeam.ts';

/** What is to be computed. */
export interface RunOptions {
  /** What moves. */
  readonly system: System;
  /** Not modified. */
  readonly start: State;
  /**
   * For a resumed run: start time of the whole run [s], the frame number of `start`, and what was counted until then;
   * makes a resumed run bit-identical to an uninterrupted one.
   */
  readonly since?: { readonly t: number; readonly frames: number; readonly tally: RunTally };
  /** How: one of `METHODS`. */
  readonly method: IntegrationMethod;
  /** From `start.t` on [s]. */
  readonly duration: number;
  /** Interval of frames [s]. */
  readonly every: number;
  /**
   * Maximum step [s]; default: a tenth of the stability limit of an explicit method. An integer number of equal steps
   * makes up `every`.
   */
  readonly step?: number;
  /**
   * Adaptive steps: the errors of all steps within a second sum to at most this, in the position of any point [m] and
   * in its velocity [m/s] (adaptiveSteps.ts). `step` is then the maximum; default: a frame, or the stability limit of
   * an explicit method.
   */
  readonly tolerance?: number;
  /** Whether a run goes on whose steps are too long for its method while its energy grows, to show it; until a point would reach c, or no number is finite. */
  readonly evenUnstable?: boolean;
  /** Threads for the steps of splittings where they pay; the result is the same to the bit. Not in a page's main thread. */
  readonly threads?: TeamThreads;
}

/** What is counted from the start of a run. */
export interface RunTally {
  /** Number of steps. */
  readonly steps: number;
  /** Energy that drag has taken [J]; absent: not known, because drag acts on a GPU. */
  readonly dragLoss?: number;
  /** Number of steps, of which adaptive ones count both attempts, that an energy correction changed; absent: none is made. */
  readonly corrected?: number;
}

/** The tally before the first step. */
export const NO_STEPS: RunTally = { steps: 0, dragLoss: 0 };

/** A state that a run yields at an interval. */
export interface SimulationFrame extends RunTally {
  /** A copy, which the caller may keep. */
  readonly state: State;
  /** Its energies and momenta. */
  readonly quantities: ConservedQuantities;
}

/** Why a run ended early. */
export interface EarlyStop {
  /** Why, for programs. */
  readonly reason: StepFailureReason;
  /** [s] */
  readonly t: number;
  /** Why, for people. */
  readonly message: Message;
  /** The affected point, if there is one. */
  readonly point?: number;
  /** The last state before, after the last frame; finite, every point slower than light. Absent: there is none. */
  readonly last?: State;
}

/** Default step as a fraction of the stability limit 2/ω. */
const DEFAULT_STEP_FRACTION = 0.1;
/** Maximum of adaptive steps as a fraction of the stability limit, if there is one. */
const MAX_STEP_FRACTION = 0.9;
/** Default steps per frame if nothing oscillates. */
const DEFAULT_STEPS_PER_FRAME = 10;
const MAX_STEPS = 1e9;

/** How a run is divided into steps. */
export interface StepSchedule {
  /** Maximum step [s]. */
  readonly h: number;
  /** Number of steps, or the minimum if they adapt. */
  readonly perFrame: number;
  /** Whether h < 2/ω, for methods that require it; otherwise perturbations may grow at every step. */
  readonly stable: boolean;
}

/**
 * Step size and count for a run's options.
 * @example
 * // A spring pendulum of ω² ≤ 400/s²: a step below 2/ω, and ten frames a second.
 * const spring = { ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(100), lengths: Float64Array.of(1) };
 * const system = makeSystem({ masses: Float64Array.of(1, 1), forces: [springForce(spring)] });
 * const start = stateAtRest(Float64Array.of(0, 0, 0, 1.2, 0, 0));
 * stepSchedule({ system, start, method: METHODS.get('leapfrog')!, duration: 1, every: 0.1 }).stable; // true
 */
export function stepSchedule(options: RunOptions): StepSchedule {
  const { system, method, every } = options;
  const omega = maxAngularFrequency(system);
  const perFrame = Math.max(1, Math.ceil(every / maxStepLength(options, omega) - 1e-9));
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
 * Runs a system frame by frame, starting with the initial state. Returns the reason if it ended early; the last yielded
 * frame is valid. A generator, so that the caller can cancel, and resume from any frame's state.
 * @example
 * // A kilogram is pushed by 10 N for 1 s, with c = 10 m/s: p = 10 kg m/s, v = c/√2.
 * const masses = Float64Array.of(1);
 * const system = makeSystem({ masses, c: 10, forces: [uniformField(masses, [10, 0, 0])] });
 * const start = stateAtRest(new Float64Array(3));
 * const frames = [...integrate({ system, start, method: METHODS.get('leapfrog')!, duration: 1, every: 0.1 })];
 * frames.at(-1)!.state.p; // [10.0, 0, 0] kg m/s
 * frames.at(-1)!.quantities.fastest; // 7.071 m/s
 */
export function* integrate(options: RunOptions): Generator<SimulationFrame, EarlyStop | undefined> {
  const course = new FrameBuilder(options);
  const last = copyState(options.start);
  const team = openTeam(options, course.stepCount);
  const state = team?.state ?? copyState(options.start);
  const advance = advancer(options, course.steps, last, team);
  try {
    yield course.start();
    while (!course.isDone) {
      let frame: SimulationFrame;
      try {
        frame = course.next(state, advance(state));
      } catch (error) {
        return earlyStopFor(error, state.t, last);
      }
      yield frame;
    }
    return undefined;
  } finally {
    team?.release();
  }
}

/** Adaptive steps alternate between states, of which a team has one. */
function openTeam({ system, start, method, tolerance, threads }: RunOptions, steps: number): ThreadTeam | undefined {
  if (!threads || !method.coefficients || tolerance !== undefined) return undefined;
  const size = teamSize(system, steps, threads.count);
  return size > 1 ? new ThreadTeam(system, start, size, threads) : undefined;
}

/** Makes the frames of a run, for any integrator. */
export class FrameBuilder {
  readonly steps: StepSchedule;
  private readonly order: RunOptions;
  private readonly frames: number;
  private readonly first: ConservedQuantities;
  private frame = 0;

  constructor(options: RunOptions) {
    this.order = options;
    this.steps = stepSchedule(options);
    this.frames = Math.round(options.duration / options.every);
    if (!(this.stepCount <= MAX_STEPS)) throw new RangeError(`${this.stepCount} steps are too many`);
    this.first = conservedQuantities(options.system, options.start);
  }

  /** Of the whole run. */
  get stepCount(): number {
    return this.frames * this.steps.perFrame;
  }

  get isDone(): boolean {
    return this.frame === this.frames;
  }

  start = (): SimulationFrame => ({
    state: copyState(this.order.start),
    quantities: this.first,
    ...(this.order.since?.tally ?? NO_STEPS),
  });

  /** The next frame, from a state and its tally. Throws a StepFailure if the state is not plausible. */
  next(state: State, tally: RunTally): SimulationFrame {
    const { order: options, first } = this;
    assertFinite(state);
    const now = conservedQuantities(options.system, state);
    assertEnergyBounded(options, this.steps, first, now);
    this.frame++;
    // Recomputed, since sums of many steps accumulate rounding errors.
    const { t, frames } = options.since ?? { t: options.start.t, frames: 0 };
    state.t = t + (frames + this.frame) * options.every;
    return { state: copyState(state), quantities: now, ...tally };
  }
}

/** The reason for a run's end at t from a StepFailure; other errors are rethrown. `last`: the last state before that. */
export function earlyStopFor(error: unknown, t: number, last?: State): EarlyStop {
  if (!(error instanceof StepFailure)) throw error;
  const { reason, text, point } = error;
  const reached = last && hasFiniteValues(last) ? copyState(last) : undefined;
  return { reason, t, message: text, ...(point !== undefined && { point }), ...(reached && { last: reached }) };
}

const hasFiniteValues = ({ x, p }: State): boolean => x.every(Number.isFinite) && p.every(Number.isFinite);

/** Returns a function that advances a state by one frame and returns the tally; `last` becomes the last state that points reach below the speed of light. */
function advancer(
  options: RunOptions,
  { h, perFrame, stable }: StepSchedule,
  last: State,
  team: ThreadTeam | undefined,
): (state: State) => RunTally {
  const { system, method, every, tolerance, since, evenUnstable } = options;
  const mover = new Integrator(system, method, team);
  const start = since?.tally ?? NO_STEPS;
  const from = copyState(options.start);
  let { steps } = start;
  mover.dragLoss = start.dragLoss ?? 0;
  const tally = (): RunTally => ({
    steps,
    dragLoss: mover.dragLoss,
    ...(mover.corrected !== undefined && { corrected: (start.corrected ?? 0) + mover.corrected }),
  });
  if (tolerance !== undefined) {
    const adaptive = new AdaptiveSteps(mover, system, { order: method.order, tolerance, longest: h });
    return (state) => {
      assignState(last, state);
      steps += adaptive.advance(state, every);
      return tally();
    };
  }
  return (state) => {
    assignState(from, state);
    assignState(last, state);
    if (!stable || !mover.takeAtOnce(state, h, perFrame))
      for (let i = 0; i < perFrame; i++) {
        mover.step(state, h);
        if (isWithinLight(system, from, state)) assignState(last, state);
      }
    if (evenUnstable && !stable) assertWithinLight(system, from, state);
    steps += perFrame;
    return tally();
  };
}

/** Whether every point has moved by less than light goes; not so by methods that correct velocities after the step. */
function isWithinLight({ c }: System, from: State, to: State): boolean {
  const reach = (c * (to.t - from.t)) ** 2;
  for (let j = 0; j < to.x.length; j += 3) {
    const square = (to.x[j] - from.x[j]) ** 2 + (to.x[j + 1] - from.x[j + 1]) ** 2 + (to.x[j + 2] - from.x[j + 2]) ** 2;
    if (!(square < reach)) return false;
  }
  return true;
}

function assertWithinLight(system: System, from: State, to: State): void {
  try {
    momenta(
      system,
      to.x.map((value, j) => (value - from.x[j]) / (to.t - from.t)),
    );
  } catch (error) {
    if (!(error instanceof SystemError)) throw error;
    throw new StepFailure('light', msg`${error.text}; take a smaller step`, error.point);
  }
}

/** Beyond the stability limit, growing energy ends the run. */
function assertEnergyBounded(
  options: RunOptions,
  { h, stable }: StepSchedule,
  first: ConservedQuantities,
  now: ConservedQuantities,
): void {
  if (stable || options.evenUnstable || now.total - first.total <= MAX_ENERGY_GAIN * now.kinetic) return;
  const bound = (2 / maxAngularFrequency(options.system)).toPrecision(3);
  const gain = Number((now.total - first.total).toPrecision(3));
  const message = msg`the energy has grown by ${gain} J: steps of ${h.toPrecision(3)} s are longer than the method can take here, ${bound} s; take shorter ones`;
  throw new StepFailure('unstable', message);
}
