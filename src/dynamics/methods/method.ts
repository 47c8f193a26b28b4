import type { State, System } from '../system.ts';

/** A way to go from one time to the next. */
export interface IntegrationMethod {
  readonly id: string;
  /** The error of a given time grows like this power of the step. */
  readonly order: number;
  /** Steps longer than 2/ω of the fastest oscillation run away. */
  readonly conditionallyStable: boolean;
  /** Of a splitting, its shares of h: x goes on for half of the first, p is pushed for the first, x goes on for half of the first and half of the second, and so on. */
  readonly coefficients?: readonly number[];
  begin(system: System): Stepper;
}

/** What a method does with one system; it keeps room for its work. */
export interface Stepper {
  /** Takes the state h [s] further. Throws a StepFailure where it cannot; the state is then worth nothing. */
  step(state: State, h: number): void;
}

/** Why a step could not be done. */
export type StepFailureReason =
  /** A point reached the speed of light. */
  | 'light'
  /** The matrix of a linear step is not positive definite any more. */
  | 'indefinite'
  /** The equations of an implicit step were not solved. */
  | 'unsolved'
  /** Something is no number. */
  | 'infinite'
  /** A point went through what is solid. */
  | 'pierced'
  /** Steps are longer than the stability bound, and the energy grows. */
  | 'unstable'
  /** No step is short enough for the tolerance. */
  | 'tolerance'
  /** The GPU that it was computed on is gone. */
  | 'lost';

export class StepFailure extends Error {
  readonly reason: StepFailureReason;
  /** That it happened to first, where it is one. */
  readonly point: number | undefined;

  constructor(reason: StepFailureReason, message: string, point?: number) {
    super(message);
    this.reason = reason;
    this.point = point;
  }
}

/** The force of all potentials on each point [N]. */
export function potentialForces({ forces }: System, x: Float64Array, out: Float64Array): void {
  out.fill(0);
  for (const force of forces) force.add(x, out);
}
