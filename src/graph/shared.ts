import type { Cancellation, Outputs, Progress } from './nodeType.ts';
import type { NodeResult } from './results.ts';

/** What an evaluation brings along. */
export interface Errand<Services> {
  readonly services: Services;
  readonly signal?: Cancellation;
  readonly progress: (node: string, ...report: Parameters<Progress>) => void;
  readonly onInterim?: (node: string) => void;
  readonly interims?: 'stopped' | 'all';
  /** Results that rest on interims: they serve this evaluation and the next, and are not kept. */
  readonly passing: Map<string, NodeResult>;
}

/** Whom a piece of work is for: all evaluations that need it. It is cancelled when the last of them is, and all hear how far it is. */
export class Shared<Services> implements Cancellation {
  /** What there is so far. */
  interim: Outputs | undefined;
  /** When there is something. */
  readonly begun: Promise<void>;
  readonly #errands: Errand<Services>[] = [];
  readonly #tell: Progress[] = [];
  readonly #tellInterim: (() => void)[] = [];
  readonly #listeners: (() => void)[] = [];
  #begin = (): void => {};
  #ended = false;

  /** `resume`: what there was of the same work, which was cancelled. */
  constructor(errand: Errand<Services>, node: string, resume?: Outputs) {
    this.begun = new Promise((done) => {
      this.#begin = done;
    });
    this.join(errand, node);
    if (resume) this.give(resume);
  }

  get aborted(): boolean {
    return this.#ended || this.#errands.every(({ signal }) => signal?.aborted);
  }

  readonly progress: Progress = (part, what) => {
    for (const tell of this.#tell) tell(part, what);
  };

  readonly give = (interim: Outputs): void => {
    if (this.aborted) return;
    this.interim = interim;
    this.#begin();
    // Not before the evaluation that has just begun this work has begun all that it can.
    void this.begun.then(() => {
      for (const tell of this.#tellInterim) tell();
    });
  };

  join(errand: Errand<Services>, node: string): void {
    this.#errands.push(errand);
    this.#tell.push((part, what) => errand.progress(node, part, what));
    this.#tellInterim.push(() => errand.onInterim?.(node));
    if (this.#listeners.length > 0) this.#watch(errand);
  }

  addEventListener(_: 'abort', listener: () => void): void {
    this.#listeners.push(listener);
    if (this.#listeners.length === 1) for (const errand of this.#errands) this.#watch(errand);
  }

  #watch({ signal }: Errand<Services>): void {
    signal?.addEventListener('abort', () => {
      if (this.#ended || !this.aborted) return;
      this.#ended = true;
      for (const listener of this.#listeners) listener();
    });
  }
}
