import type { Outputs, ReportInterim } from '../nodeType.ts';

/** Between two interims lies at least so long [ms], and so many times as long as the last took to make and send. */
const MIN_INTERVAL = 250;
const COST_RATIO = 25;

/** Gives the first interim at once, and others at distances that grow with what they cost: it stays a few percent of the work. */
export function throttleInterims(give: (outputs: Outputs) => void): ReportInterim {
  let next = Number.NEGATIVE_INFINITY;
  return (make) => {
    const began = performance.now();
    if (began < next) return;
    give(make());
    const ended = performance.now();
    next = ended + Math.max(MIN_INTERVAL, COST_RATIO * (ended - began));
  };
}

/** What there was of so many pieces of work that were cancelled is kept. */
const MAX_KEPT = 4;

/** What there was of cancelled work, under its content. */
export class InterimCache {
  /** The oldest first. */
  private readonly kept = new Map<string, Outputs>();

  get(content: string): Outputs | undefined {
    return this.kept.get(content);
  }

  set(content: string, interim: Outputs): void {
    this.kept.delete(content);
    this.kept.set(content, interim);
    for (const oldest of this.kept.keys()) {
      if (this.kept.size <= MAX_KEPT) break;
      this.kept.delete(oldest);
    }
  }

  delete(content: string): void {
    this.kept.delete(content);
  }
}
