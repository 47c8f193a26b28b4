import { msg } from '../messages/message.ts';
import type { Integrator } from './integrator.ts';
import { StepFailure } from './methods/method.ts';
import { assignState, type State, type System, velocities } from './system.ts';

/** Factor on the step that the error estimate asks for, and limits on the change of the step at once. */
const SAFETY_FACTOR = 0.9;
const [SHRINK, GROW] = [0.2, 4];
/** Shortest step as a fraction of the longest. */
const MIN_STEP_RATIO = 1e-9;

/**
 * Adaptive steps. Each step is taken twice, whole and in two halves; the halves are kept if both agree within tolerance
 * · h: in the position of every point [m] and in its velocity [m/s], since a velocity error moves a point by as much in
 * a second. The halves are more accurate than their difference to the whole, so the errors of all steps in a second sum
 * to less than the tolerance. How the system amplifies errors later is not controlled. Each frame starts anew with the
 * longest step, so that a run can be resumed from any frame. Steps that depend on the state are not symplectic:
 * splittings lose their bounded energy error. Source: Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations
 * I", §II.4.
 */
export class AdaptiveSteps {
  private readonly mover: Integrator;
  private readonly system: System;
  private readonly settings: AdaptiveSettings;
  private readonly whole: State;
  private readonly halves: State;
  private readonly v: readonly [Float64Array, Float64Array];

  constructor(mover: Integrator, system: System, settings: AdaptiveSettings) {
    this.mover = mover;
    this.system = system;
    this.settings = settings;
    const room = (): Float64Array => new Float64Array(3 * system.masses.length);
    this.whole = { t: 0, x: room(), p: room() };
    this.halves = { t: 0, x: room(), p: room() };
    this.v = [room(), room()];
  }

  /**
   * Advances the state by `time`; returns the number of accepted steps. Throws a StepFailure if no step is short
   * enough.
   */
  advance(state: State, time: number): number {
    const { order, longest } = this.settings;
    let steps = 0;
    for (let left = time, h = longest; left > 0; ) {
      const parts = Math.ceil(left / Math.min(h, longest) - 1e-9);
      const taken = left / parts;
      const error = this.attempt(state, taken, taken <= MIN_STEP_RATIO * longest);
      if (error <= 1) {
        steps += 2;
        left = parts === 1 ? 0 : left - taken;
      }
      h = taken * Math.min(GROW, Math.max(SHRINK, SAFETY_FACTOR * error ** (-1 / order)));
    }
    return steps;
  }

  /**
   * Difference between whole and halves relative to the tolerance; if it is at most 1 the state becomes that of the
   * halves.
   */
  private attempt(state: State, h: number, last: boolean): number {
    const { whole, halves, mover } = this;
    assignState(whole, state);
    assignState(halves, state);
    const { dragLoss } = mover;
    try {
      mover.step(whole, h);
      mover.dragLoss = dragLoss;
      mover.step(halves, h / 2);
      mover.step(halves, h / 2);
    } catch (failure) {
      mover.dragLoss = dragLoss;
      if (last || !(failure instanceof StepFailure)) throw failure;
      return Number.POSITIVE_INFINITY;
    }
    const error = this.difference() / (this.settings.tolerance * h);
    if (error <= 1) {
      assignState(state, halves);
      return error;
    }
    mover.dragLoss = dragLoss;
    if (last)
      throw new StepFailure('tolerance', msg`even steps of ${h.toExponential(1)} s err too much; allow a larger error`);
    return Number.isNaN(error) ? Number.POSITIVE_INFINITY : error;
  }

  /** Maximum over the points, of position [m] and velocity [m/s] differences. */
  private difference(): number {
    const { whole, halves, v, system } = this;
    const { pinned } = system;
    velocities(system, whole.p, v[0]);
    velocities(system, halves.p, v[1]);
    return Math.sqrt(Math.max(maxSquaredDistance(whole.x, halves.x, pinned), maxSquaredDistance(v[0], v[1], pinned)));
  }
}

interface AdaptiveSettings {
  /** Order of the method. */
  readonly order: number;
  /** [m/s] */
  readonly tolerance: number;
  /** [s] */
  readonly longest: number;
}

/** Over points that are not pinned; NaN if any component is. */
function maxSquaredDistance(a: Float64Array, b: Float64Array, pinned: Uint8Array): number {
  let most = 0;
  for (let j = 0; j < a.length; j += 3) {
    if (pinned[j / 3]) continue;
    const square = (a[j] - b[j]) ** 2 + (a[j + 1] - b[j + 1]) ** 2 + (a[j + 2] - b[j + 2]) ** 2;
    if (!(square <= most)) most = square;
  }
  return most;
}
