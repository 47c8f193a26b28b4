import type { Force, PairForceData, UniformFieldData } from '../forces/force.ts';
import type { SplittingWork } from '../methods/method.ts';
import { SplittingRange } from '../methods/splittingRange.ts';
import type { State, System } from '../system.ts';
import { DRIFT, END, KICK, kickTogether, type TeamTask } from './teamHelper.ts';
import { BARRIER_WORDS, ThreadBarrier } from './threadBarrier.ts';

/** Threads that a program lends to a simulation. */
export interface TeamThreads {
  /** How many may work at once, with the one that asks. */
  readonly count: number;
  /** Starts one that calls `serveTeam` with the task and does not keep the program alive. */
  start(task: TeamTask): void;
}

/** How long a thread may take to start, or for a stage, before it is given up [ms]. */
const PATIENCE = 60_000;
/** Fewer points a thread are not worth its barriers. */
export const MIN_POINTS = 2000;
/** Fewer points × steps in all are not worth its start. */
const MIN_WORK = 50_000_000;

/**
 * How many threads pay for a run: 1 where its forces are not all springs and uniform fields, which alone are summed in
 * parts, or where there is little to do.
 */
export function teamSize({ forces, masses }: System, steps: number, count: number): number {
  const points = masses.length;
  if (points * steps < MIN_WORK || forces.some(({ bind }) => bind === undefined)) return 1;
  return Math.max(1, Math.min(count, Math.floor(points / MIN_POINTS)));
}

/**
 * Threads that share the points of a system and take the steps of a splitting together, each with the points of a range.
 * Each point sums its forces in the same order as in one thread: the state is the same to the bit, whatever their
 * number. The thread that asks works too, and must be one that may wait (not a page's main thread).
 */
export class ThreadTeam implements SplittingWork {
  /** The state that it steps, in shared memory. */
  readonly state: State;
  private readonly range: SplittingRange;
  private readonly barrier: ThreadBarrier;
  private readonly orders = sharedNumbers(3);

  /** `size`: number of threads, with this one, ≥ 2. */
  constructor(system: System, start: State, size: number, threads: TeamThreads) {
    const { forces, kinematic: _, ...rest } = system;
    const points = system.masses.length;
    const border = (thread: number): number => Math.round((thread * points) / size);
    this.state = { t: start.t, x: sharedNumbers(start.x.length), p: sharedNumbers(start.p.length) };
    this.state.x.set(start.x);
    this.state.p.set(start.p);
    const words = new Int32Array(new SharedArrayBuffer(BARRIER_WORDS * Int32Array.BYTES_PER_ELEMENT));
    this.barrier = new ThreadBarrier(words, size);
    this.range = new SplittingRange(system, 0, border(1));
    const { x, p } = this.state;
    for (let thread = 1; thread < size; thread++)
      threads.start({
        ...{ system: rest, forces: forces.map(rangeData), x, p, words, orders: this.orders, size },
        ...{ first: border(thread), end: border(thread + 1) },
      });
  }

  drift(state: State, h: number): void {
    this.begin(state, DRIFT, h);
    this.range.drift(state, h);
    this.barrier.arrive(PATIENCE);
  }

  kick(state: State, h: number, drift: number): void {
    this.begin(state, KICK, h, drift);
    kickTogether(this.range, this.barrier, state, h, drift, PATIENCE);
    this.barrier.arrive(PATIENCE);
  }

  /** Ends the other threads. */
  release(): void {
    this.begin(this.state, END);
  }

  private begin(state: State, ...order: number[]): void {
    if (state.x !== this.state.x) throw new Error('a team of threads steps its own state');
    this.orders.set(order);
    this.barrier.arrive(PATIENCE);
  }
}

const rangeData = ({ data }: Force): PairForceData | UniformFieldData => {
  if (data.kind === 'uniform' || data.kind === 'spring') return data;
  throw new Error(`a force of the kind ${data.kind} is not computed in parts`);
};

const sharedNumbers = (count: number): Float64Array =>
  new Float64Array(new SharedArrayBuffer(count * Float64Array.BYTES_PER_ELEMENT));
