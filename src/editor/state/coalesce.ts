import { CancelledError } from '../../graph/evaluation/evaluator.ts';

/** Pause after a call, as a multiple of its duration. */
const PAUSE_FACTOR = 3;

/**
 * Returns a function that requests a call of `look`: one runs at a time, at intervals, and the last request is always
 * served.
 */
export function coalesce(observe: () => Promise<void>): () => void {
  let busy = false;
  let again = false;
  const run = async (): Promise<void> => {
    busy = true;
    while (again) {
      again = false;
      const began = performance.now();
      await observe().catch(ignoreCancelled);
      await new Promise((done) => setTimeout(done, PAUSE_FACTOR * (performance.now() - began)));
    }
    busy = false;
  };
  return () => {
    again = true;
    if (!busy) void run();
  };
}

/** The observed evaluation has ended. */
const ignoreCancelled = (error: unknown): void => {
  if (!(error instanceof CancelledError)) throw error;
};
