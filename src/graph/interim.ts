import type { GiveInterim, Outputs } from './nodeType.ts';

/** Between two interims lies at least so long [ms], and so many times as long as the last took to make and send. */
const LEAST = 250;
const TIMES = 25;

/** Gives the first interim at once, and others at distances that grow with what they cost: it stays a few percent of the work. */
export function paced(give: (outputs: Outputs) => void): GiveInterim {
  let next = Number.NEGATIVE_INFINITY;
  return (make) => {
    const began = performance.now();
    if (began < next) return;
    give(make());
    const ended = performance.now();
    next = ended + Math.max(LEAST, TIMES * (ended - began));
  };
}

/** What there was of so many pieces of work that were cancelled is kept. */
const MOST = 4;

/** What there was of cancelled work, under its content. */
export class Stopped {
  /** The oldest first. */
  readonly #kept = new Map<string, Outputs>();

  get(content: string): Outputs | undefined {
    return this.#kept.get(content);
  }

  keep(content: string, interim: Outputs): void {
    this.#kept.delete(content);
    this.#kept.set(content, interim);
    for (const oldest of this.#kept.keys()) {
      if (this.#kept.size <= MOST) break;
      this.#kept.delete(oldest);
    }
  }

  forget(content: string): void {
    this.#kept.delete(content);
  }
}
