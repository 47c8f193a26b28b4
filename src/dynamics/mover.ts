import { type Method, StepFailure, type Stepper } from './methods/method.ts';
import type { State, System } from './system.ts';

/** Takes a system's state from step to step by a method: with the air, and with an eye on what is solid. */
export class Mover {
  private readonly system: System;
  private readonly stepper: Stepper;
  private readonly before: Float64Array;

  constructor(system: System, method: Method) {
    this.system = system;
    this.stepper = method.begin(system);
    this.before = new Float64Array(3 * system.masses.length);
  }

  /** Air before and after, half of it each, so that a step stays the same when it is run backwards. Throws a StepFailure; the state is then worth nothing. */
  step(state: State, h: number): void {
    const { drag } = this.system;
    this.before.set(state.x);
    slowDown(state, (drag * h) / 2);
    this.stepper.step(state, h);
    slowDown(state, (drag * h) / 2);
    this.refusePierced(state);
  }

  private refusePierced({ x }: State): void {
    for (const force of this.system.forces) {
      const point = force.pierced?.(this.before, x);
      if (point === undefined) continue;
      const place = [0, 1, 2].map((k) => x[3 * point + k].toPrecision(4)).join(', ');
      const message = `point ${point} went through what is solid, to (${place}) m; take a smaller step, a harder penalty, or let it go slower`;
      throw new StepFailure('pierced', message, point);
    }
  }
}

function slowDown({ p }: State, much: number): void {
  if (much === 0) return;
  const share = Math.exp(-much);
  for (let j = 0; j < p.length; j++) p[j] *= share;
}

/** Throws a StepFailure where something is no number. */
export function refuseInfinite({ x, p }: State): void {
  const odd = x.findIndex((value, j) => !Number.isFinite(value) || !Number.isFinite(p[j]));
  if (odd < 0) return;
  const point = Math.floor(odd / 3);
  throw new StepFailure('infinite', `point ${point} has no place any more; take a smaller step`, point);
}
