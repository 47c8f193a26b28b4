import type { Outputs, ReportInterim } from '../nodeType.ts';

/** Minimum interval of interim results [ms], and as a multiple of the time that the last took to make and send. */
const MIN_INTERVAL = 250;
const COST_RATIO = 25;

/**
 * Gives the first interim result at once, and further ones at intervals that grow with their cost, so that they take a
 * few percent of the time.
 */
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

/** Number of cancelled computations whose interim results are kept. */
const MAX_KEPT = 4;

/** Interim results of cancelled work, by content. */
export class InterimCache {
  /** Oldest first. */
  private readonly entries = new Map<string, Outputs>();

  get(content: string): Outputs | undefined {
    return this.entries.get(content);
  }

  set(content: string, interim: Outputs): void {
    this.entries.delete(content);
    this.entries.set(content, interim);
    for (const oldest of this.entries.keys()) {
      if (this.entries.size <= MAX_KEPT) break;
      this.entries.delete(oldest);
    }
  }

  delete(content: string): void {
    this.entries.delete(content);
  }
}
