import type { RunHeavy } from '../../graph/evaluation/evaluator.ts';
import { heavyWorkerPool } from '../../graph/evaluation/heavyWorkers.ts';
import { workerError } from '../pipelines/workerError.ts';

/** Runs heavy nodes in the page's workers. */
export const heavyWorkers = (): RunHeavy =>
  heavyWorkerPool(() => {
    const worker = new Worker(new URL('./heavy.worker.ts', import.meta.url), { type: 'module' });
    return {
      send: (order) => worker.postMessage(order),
      listen: (hear, fail) => {
        worker.addEventListener('message', ({ data }) => hear(data));
        worker.addEventListener('error', ({ message }) => fail(workerError(message)));
      },
      end: () => worker.terminate(),
    };
  });
