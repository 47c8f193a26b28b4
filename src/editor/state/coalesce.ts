import { CancelledError } from '../../graph/evaluation/evaluator.ts';

/** After a look comes a pause of so many times as long. */
const PAUSE_FACTOR = 3;

/** Looks at work under way whenever it is told that there is something new: one look at a time, always at the latest. */
export function coalesce(look: () => Promise<void>): () => void {
  let busy = false;
  let again = false;
  const go = async (): Promise<void> => {
    busy = true;
    while (again) {
      again = false;
      const began = performance.now();
      await look().catch(ignoreCancelled);
      await new Promise((done) => setTimeout(done, PAUSE_FACTOR * (performance.now() - began)));
    }
    busy = false;
  };
  return () => {
    again = true;
    if (!busy) void go();
  };
}

/** What was looked at has ended. */
const ignoreCancelled = (error: unknown): void => {
  if (!(error instanceof CancelledError)) throw error;
};
