import type { AbortSignalLike, Outputs, ProgressCallback } from '../nodeType.ts';
import type { NodeResult } from './resultCache.ts';

/** The options and state of one evaluation. */
export interface EvaluationJob<Services> {
  readonly services: Services;
  readonly signal?: AbortSignalLike;
  readonly progress: (node: string, ...report: Parameters<ProgressCallback>) => void;
  readonly onInterim?: (node: string) => void;
  readonly interims?: 'stopped' | 'all';
  /** Results that depend on interim results: used by this evaluation and the next, not cached. */
  readonly interimResults: Map<string, NodeResult>;
}

/** Work shared by all evaluations that need it. It is cancelled when the last of them is; all get its progress. */
export class SharedWork<Services> implements AbortSignalLike {
  /** The latest interim result. */
  interim: Outputs | undefined;
  /** Resolves with the first interim result. */
  readonly firstInterim: Promise<void>;
  private readonly errands: EvaluationJob<Services>[] = [];
  private readonly notify: ProgressCallback[] = [];
  private readonly tellInterim: (() => void)[] = [];
  private readonly listeners: (() => void)[] = [];
  private begin = (): void => {};
  private ended = false;

  /** `resume`: the interim result of the same work, if it was cancelled before. */
  constructor(job: EvaluationJob<Services>, node: string, resume?: Outputs) {
    this.firstInterim = new Promise((done) => {
      this.begin = done;
    });
    this.join(job, node);
    if (resume) this.reportInterim(resume);
  }

  get aborted(): boolean {
    return this.ended || this.errands.every(({ signal }) => signal?.aborted);
  }

  readonly progress: ProgressCallback = (part, what) => {
    for (const notify of this.notify) notify(part, what);
  };

  readonly reportInterim = (interim: Outputs): void => {
    if (this.aborted) return;
    this.interim = interim;
    this.begin();
    // Deferred until the evaluation that started this work has started everything it can.
    void this.firstInterim.then(() => {
      for (const notify of this.tellInterim) notify();
    });
  };

  join(job: EvaluationJob<Services>, node: string): void {
    this.errands.push(job);
    this.notify.push((part, what) => job.progress(node, part, what));
    this.tellInterim.push(() => job.onInterim?.(node));
    if (this.listeners.length > 0) this.watch(job);
  }

  addEventListener(_: 'abort', listener: () => void): void {
    this.listeners.push(listener);
    if (this.listeners.length === 1) for (const job of this.errands) this.watch(job);
  }

  private watch({ signal }: EvaluationJob<Services>): void {
    signal?.addEventListener('abort', () => {
      if (this.ended || !this.aborted) return;
      this.ended = true;
      for (const listener of this.listeners) listener();
    });
  }
}
