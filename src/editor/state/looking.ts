import { CancelledError } from '../../graph/evaluate.ts';

/** After a look comes a pause of so many times as long. */
const PAUSE = 3;

/** Looks at work under way whenever it is told that there is something new: one look at a time, always at the latest. */
export function looking(look: () => Promise<void>): () => void {
  let busy = false;
  let again = false;
  const go = async (): Promise<void> => {
    busy = true;
    while (again) {
      again = false;
      const began = performance.now();
      await look().catch(unlessCancelled);
      await new Promise((done) => setTimeout(done, PAUSE * (performance.now() - began)));
    }
    busy = false;
  };
  return () => {
    again = true;
    if (!busy) void go();
  };
}

/** What was looked at has ended. */
const unlessCancelled = (error: unknown): void => {
  if (!(error instanceof CancelledError)) throw error;
};
