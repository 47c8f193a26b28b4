import type { Message } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { State, System } from '../system.ts';

/** A numerical integration method. */
export interface IntegrationMethod {
  /** Short and stable, for flags and files. */
  readonly id: string;
  /** Order: the error at a fixed time scales as this power of the step. */
  readonly order: number;
  /** Whether steps longer than 2/ω of the fastest oscillation are unstable. */
  readonly conditionallyStable: boolean;
  /**
   * For compositions of leapfrogs: fractions of h. x drifts by half of the first, p is kicked by the first, x drifts by
   * half of the first and half of the second, and so on.
   */
  readonly coefficients?: readonly number[];
  /** Prepares it for a system. `work`: who computes the stages of a splitting; default: this thread. */
  begin(system: System, work?: SplittingWork): Stepper;
}

/** The stages of a splitting's step, for all points of a system. */
export interface SplittingWork {
  /** x += h p/γm; h [s] */
  drift(state: State, h: number): void;
  /** p += h F(x), then a drift by `drift` [s]. */
  kick(state: State, h: number, drift: number): void;
}

/** A method applied to one system, with its scratch buffers. */
export interface Stepper {
  /** Steps so far that an energy correction has changed; absent: it has none. */
  readonly corrected?: number;
  /** Advances the state by h [s]. Throws a StepFailure; the state is then invalid. */
  step(state: State, h: number): void;
  /**
   * Advances the state by `count` steps of h, cheaper than one by one, and the same but for rounding. Absent: there is
   * nothing to gain.
   */
  steps?(state: State, h: number, count: number): void;
}

/** Why a step failed. */
export type StepFailureReason =
  /** A point reached the speed of light. */
  | 'light'
  /** The matrix of a linearized step is not positive definite. */
  | 'indefinite'
  /** The equations of an implicit step were not solved. */
  | 'unsolved'
  /** A value is not finite. */
  | 'infinite'
  /** A point passed through a solid. */
  | 'pierced'
  /** No velocities conserve the energy. */
  | 'energy'
  /** Steps exceed the stability limit, and the energy grows. */
  | 'unstable'
  /** No step is short enough for the tolerance. */
  | 'tolerance'
  /** The GPU device was lost. */
  | 'lost';

/**
 * A step that could not be made.
 * @example
 * import { msg } from 'slowlight/messages';
 * const failure = new StepFailure('light', msg`point 3 reached the speed of light`, 3);
 * failure.reason; // 'light'
 */
export class StepFailure extends MessageError {
  /** Why, for programs. */
  readonly reason: StepFailureReason;
  /** The first affected point, if there is one. */
  readonly point: number | undefined;

  constructor(reason: StepFailureReason, text: Message, point?: number) {
    super(text);
    this.reason = reason;
    this.point = point;
  }
}

/** Total force of all potentials on each point [N]. */
export function potentialForces({ forces }: System, x: Float64Array, out: Float64Array): void {
  out.fill(0);
  for (const force of forces) force.add(x, out);
}
