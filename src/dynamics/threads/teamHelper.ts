import type { PairForceData, UniformFieldData } from '../forces/force.ts';
import { springForce } from '../forces/springs.ts';
import { uniformField } from '../forces/uniformField.ts';
import { SplittingRange } from '../methods/splittingRange.ts';
import { makeSystem, type System } from '../system.ts';
import { ThreadBarrier } from './threadBarrier.ts';

/** What a helper is to do, in the words of `TeamTask.orders`: [order, h, drift]. */
export const [DRIFT, KICK, END] = [0, 1, 2];

/** Data for a thread of a team, as a message. */
export interface TeamTask {
  /** A copy. */
  readonly system: Omit<System, 'forces'>;
  /** What its forces are made of. */
  readonly forces: readonly (PairForceData | UniformFieldData)[];
  /** In shared memory [m]. */
  readonly x: Float64Array;
  /** In shared memory [kg m/s]. */
  readonly p: Float64Array;
  /** Of the barrier. */
  readonly words: Int32Array;
  /** What is to be done. */
  readonly orders: Float64Array;
  /** Number of threads. */
  readonly size: number;
  /** The thread's first point. */
  readonly first: number;
  /** The point after its last. */
  readonly end: number;
}

/**
 * Serves a run with `threads` in a thread of its own, until it ends. Blocks the thread.
 * @example
 * // In a worker of Node.js: new Worker(file, { workerData: task }).unref()
 * import { workerData } from 'node:worker_threads';
 * const help = () => serveTeam(workerData);
 */
export function serveTeam({ system, forces, x, p, words, orders, size, first, end }: TeamTask): void {
  const whole = makeSystem({
    ...system,
    forces: forces.map((data) =>
      data.kind === 'uniform'
        ? uniformField(data.amounts, data.field)
        : springForce({ ends: data.ends, stiffness: data.strengths, lengths: data.lengths }),
    ),
  });
  const range = new SplittingRange(whole, first, end);
  const barrier = new ThreadBarrier(words, size);
  const state = { t: 0, x, p };
  for (;;) {
    barrier.arrive();
    const [order, h, drift] = orders;
    if (order === END) return;
    if (order === DRIFT) range.drift(state, h);
    else kickTogether(range, barrier, state, h, drift);
    barrier.arrive();
  }
}

/** Forces need the places of all points before any moves. */
export function kickTogether(
  range: SplittingRange,
  barrier: ThreadBarrier,
  state: { readonly t: number; readonly x: Float64Array; readonly p: Float64Array },
  h: number,
  drift: number,
  patience?: number,
): void {
  range.sumForces(state);
  barrier.arrive(patience);
  range.applyForces(state, h, drift);
}
