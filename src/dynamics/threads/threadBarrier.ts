/** Words of a barrier in shared memory: [generation, arrived, sleeping]. */
export const BARRIER_WORDS = 3;
const [GENERATION, ARRIVED, SLEEPING] = [0, 1, 2];
/** Looks before a thread sleeps: some 20 µs, since waking one takes as long as many stages of a step. */
const SPINS = 4000;

/**
 * Holds threads until all have arrived. They look for a while, then sleep. What a thread wrote before is seen by all
 * behind it. Source: Herlihy and Shavit, "The Art of Multiprocessor Programming", §18.3.
 */
export class ThreadBarrier {
  private readonly words: Int32Array;
  private readonly size: number;

  /** `words`: BARRIER_WORDS in shared memory, 0 at first; `size`: number of threads. */
  constructor(words: Int32Array, size: number) {
    this.words = words;
    this.size = size;
  }

  /** `patience`: throws after so long [ms]. */
  arrive(patience = Number.POSITIVE_INFINITY): void {
    const { words, size } = this;
    const generation = Atomics.load(words, GENERATION);
    if (Atomics.add(words, ARRIVED, 1) === size - 1) {
      Atomics.store(words, ARRIVED, 0);
      Atomics.add(words, GENERATION, 1);
      if (Atomics.load(words, SLEEPING) > 0) Atomics.notify(words, GENERATION);
      return;
    }
    for (let spin = 0; spin < SPINS; spin++) if (Atomics.load(words, GENERATION) !== generation) return;
    Atomics.add(words, SLEEPING, 1);
    while (Atomics.load(words, GENERATION) === generation)
      if (Atomics.wait(words, GENERATION, generation, patience) === 'timed-out')
        throw new Error('a thread of the simulation does not answer');
    Atomics.sub(words, SLEEPING, 1);
  }
}
