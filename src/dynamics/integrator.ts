import { dot, length, scale, sub, type Vec3 } from '../math/vec3.ts';
import { type LocalizedText, msg } from '../messages/message.ts';
import { kineticEnergy } from './energy.ts';
import { type IntegrationMethod, type SplittingWork, StepFailure, type Stepper } from './methods/method.ts';
import { leapfrog } from './methods/splitting.ts';
import { momentum, pointAt, pointName, type State, type System } from './system.ts';

/** Advances a system's state by a method, with drag and kinematic points, and detects tunneling. */
export class Integrator {
  private readonly system: System;
  private readonly stepper: Stepper;
  /** Fractions of a step, each with drag before and after it. */
  private readonly fractions: readonly number[];
  private readonly before: Float64Array;
  /** Momenta of kinematic points. */
  private readonly kinematicMomenta: Float64Array;
  /** Energy that drag has taken so far [J]. Settable, for steps that are taken back. */
  dragLoss = 0;

  /** `work`: who computes the stages of a splitting; default: this thread. */
  constructor(system: System, method: IntegrationMethod, work?: SplittingWork) {
    this.system = system;
    // With drag a composition of leapfrogs keeps its order only if each has its own drag; around the whole it would be
    // second order.
    const row = system.drag > 0 ? method.coefficients : undefined;
    this.stepper = (row ? leapfrog : method).begin(system, work);
    this.fractions = row ?? [1];
    this.before = new Float64Array(3 * system.masses.length);
    this.kinematicMomenta = new Float64Array(3 * (system.kinematic?.length ?? 0));
  }

  /** Steps so far that the method's energy correction has changed; undefined: it has none. */
  get corrected(): number | undefined {
    return this.stepper.corrected;
  }

  /**
   * Half of the drag before and half after, so that the step is time-reversible. Throws a StepFailure; the state is
   * then invalid.
   */
  step(state: State, h: number): void {
    const { drag } = this.system;
    this.before.set(state.x);
    const end = state.t + h;
    this.moveKinematic(state, end);
    for (const fraction of this.fractions) {
      this.applyDrag(state, (fraction * drag * h) / 2);
      this.stepper.step(state, fraction * h);
      this.applyDrag(state, (fraction * drag * h) / 2);
    }
    state.t = end;
    this.placeKinematic(state, end);
    this.assertNotTunneled(state);
  }

  /**
   * Takes equal steps at once where nothing happens between them: no drag, no kinematic points, no solids. Returns
   * whether it did.
   */
  takeAtOnce(state: State, h: number, count: number): boolean {
    const { drag, kinematic = [], forces } = this.system;
    if (!this.stepper.steps || drag > 0 || kinematic.length > 0) return false;
    if (forces.some(({ findTunneled }) => findTunneled !== undefined)) return false;
    this.stepper.steps(state, h, count);
    return true;
  }

  /** Kinematic points move uniformly to their position at the end of the step. */
  private moveKinematic({ t, x, p }: State, end: number): void {
    const { kinematic = [], c, masses } = this.system;
    kinematic.forEach(({ point, positionAt }, i) => {
      const v = scale(sub(positionAt(end), pointAt(x, point)), 1 / (end - t));
      if (!(dot(v, v) / (c * c) < 1)) {
        const message = msg`${pointName(point)} is moved at ${length(v).toPrecision(4)} m/s, not below c = ${c} m/s; move it slower`;
        throw new StepFailure('light', message, point);
      }
      this.kinematicMomenta.set(momentum(masses[point], v, c), 3 * i);
      p.set(this.kinematicMomenta.subarray(3 * i, 3 * i + 3), 3 * point);
    });
  }

  /** Sets their exact positions, and momenta from the displacement. */
  private placeKinematic({ x, p }: State, end: number): void {
    this.system.kinematic?.forEach(({ point, positionAt }, i) => {
      x.set(positionAt(end), 3 * point);
      p.set(this.kinematicMomenta.subarray(3 * i, 3 * i + 3), 3 * point);
    });
  }

  /** Damps all points except pinned ones, and accounts for the energy that they lose. */
  private applyDrag({ p }: State, exponent: number): void {
    if (exponent === 0) return;
    const { system } = this;
    const { pinned } = system;
    const fraction = Math.exp(-exponent);
    const before = kineticEnergy(system, p);
    for (let i = 0; i < pinned.length; i++) if (!pinned[i]) for (let j = 3 * i; j < 3 * i + 3; j++) p[j] *= fraction;
    this.dragLoss += before - kineticEnergy(system, p);
  }

  private assertNotTunneled({ x }: State): void {
    for (const force of this.system.forces) {
      const point = force.findTunneled?.(this.before, x);
      if (point === undefined) continue;
      throw tunnelingFailure(point, msg`to`, pointAt(x, point));
    }
  }
}

/** `where`: description of a position [m]. */
export function tunnelingFailure(point: number, where: LocalizedText, positionAt: Vec3): StepFailure {
  const at = positionAt.map((value) => value.toPrecision(4)).join(', ');
  const message = msg`${pointName(point)} went through what is solid, ${where} (${at}) m; take a smaller step, a harder penalty, or let it go slower`;
  return new StepFailure('pierced', message, point);
}

/** Throws a StepFailure if a value is not finite. */
export function assertFinite({ x, p }: State): void {
  const odd = x.findIndex((value, j) => !Number.isFinite(value) || !Number.isFinite(p[j]));
  if (odd < 0) return;
  const point = Math.floor(odd / 3);
  throw new StepFailure(
    'infinite',
    msg`${pointName(point)} has no finite position any more; take a smaller step`,
    point,
  );
}
