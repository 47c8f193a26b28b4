import type { AbortSignalLike, Outputs, ProgressCallback } from '../nodeType.ts';
import type { NodeResult } from './resultCache.ts';

/** What an evaluation brings along. */
export interface EvaluationJob<Services> {
  readonly services: Services;
  readonly signal?: AbortSignalLike;
  readonly progress: (node: string, ...report: Parameters<ProgressCallback>) => void;
  readonly onInterim?: (node: string) => void;
  readonly interims?: 'stopped' | 'all';
  /** Results that rest on interims: they serve this evaluation and the next, and are not kept. */
  readonly interimResults: Map<string, NodeResult>;
}

/** Whom a piece of work is for: all evaluations that need it. It is cancelled when the last of them is, and all hear how far it is. */
export class SharedWork<Services> implements AbortSignalLike {
  /** What there is so far. */
  interim: Outputs | undefined;
  /** When there is something. */
  readonly firstInterim: Promise<void>;
  private readonly errands: EvaluationJob<Services>[] = [];
  private readonly tell: ProgressCallback[] = [];
  private readonly tellInterim: (() => void)[] = [];
  private readonly listeners: (() => void)[] = [];
  private begin = (): void => {};
  private ended = false;

  /** `resume`: what there was of the same work, which was cancelled. */
  constructor(errand: EvaluationJob<Services>, node: string, resume?: Outputs) {
    this.firstInterim = new Promise((done) => {
      this.begin = done;
    });
    this.join(errand, node);
    if (resume) this.reportInterim(resume);
  }

  get aborted(): boolean {
    return this.ended || this.errands.every(({ signal }) => signal?.aborted);
  }

  readonly progress: ProgressCallback = (part, what) => {
    for (const tell of this.tell) tell(part, what);
  };

  readonly reportInterim = (interim: Outputs): void => {
    if (this.aborted) return;
    this.interim = interim;
    this.begin();
    // Not before the evaluation that has just begun this work has begun all that it can.
    void this.firstInterim.then(() => {
      for (const tell of this.tellInterim) tell();
    });
  };

  join(errand: EvaluationJob<Services>, node: string): void {
    this.errands.push(errand);
    this.tell.push((part, what) => errand.progress(node, part, what));
    this.tellInterim.push(() => errand.onInterim?.(node));
    if (this.listeners.length > 0) this.watch(errand);
  }

  addEventListener(_: 'abort', listener: () => void): void {
    this.listeners.push(listener);
    if (this.listeners.length === 1) for (const errand of this.errands) this.watch(errand);
  }

  private watch({ signal }: EvaluationJob<Services>): void {
    signal?.addEventListener('abort', () => {
      if (this.ended || !this.aborted) return;
      this.ended = true;
      for (const listener of this.listeners) listener();
    });
  }
}
