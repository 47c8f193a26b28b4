import { transferables } from '../../graph/evaluation/transferables.ts';
import type { ThreadHost, WorkerThread } from '../../pipelines/host.ts';
import type { Scene } from '../../scene/types.ts';
import { workerError } from './workerError.ts';

/** Memory limit for the threads' copies of the scene, together [bytes]. */
const MAX_SCENE_COPIES_BYTES = 2 ** 30;
/** Memory for caches, of all threads [bytes]. */
const CACHE_BYTES = 2 ** 29;

/** Workers of a worker, without shared memory: most pages may not have that. */
export const workerThreads: ThreadHost = {
  count: threadsFor,
  cacheBytes: (threads) => CACHE_BYTES / threads,
  share: (data) => data,
  start: startThread,
  explain: (error) => error,
};

/** One core is left to the page; large scenes get fewer copies. */
function threadsFor(scene: Scene): number {
  const bytes = transferables(scene).reduce((sum, { byteLength }) => sum + byteLength, 1);
  return Math.max(1, Math.min(navigator.hardwareConcurrency - 1, Math.floor(MAX_SCENE_COPIES_BYTES / bytes)));
}

function startThread<Message, Reply>(pipeline: string): WorkerThread<Message, Reply> {
  const worker = new Worker(new URL('./pipelineThread.worker.ts', import.meta.url), { type: 'module', name: pipeline });
  return {
    send: (message) => worker.postMessage(message),
    listen: (hear, fail) => {
      worker.addEventListener('message', ({ data }) => hear(data));
      worker.addEventListener('error', ({ message }) => fail(workerError(message)));
    },
    terminate: () => {
      worker.terminate();
      return undefined;
    },
  };
}
