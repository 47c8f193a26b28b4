import { availableParallelism } from 'node:os';
import { type ResourceLimits, Worker } from 'node:worker_threads';
import { type LocalizedText, msg } from '../../messages/message.ts';
import type { ThreadHost, WorkerThread } from '../../pipelines/host.ts';
import { unavailable } from '../terminal/exitCodes.ts';
import { toSharedMemory } from './sharedMemory.ts';

/** Cache memory of all threads together, and the maximum of one thread [bytes]. */
const [CACHES, MAX_CACHE] = [4 * 2 ** 30, 256 * 2 ** 20];

/** Worker threads of Node that share the scene's arrays. `limits` per thread; Node's defaults if absent. */
export const nodeThreads = (limits?: ResourceLimits): ThreadHost => ({
  count: () => availableParallelism(),
  cacheBytes: (threads) => Math.min(MAX_CACHE, CACHES / threads),
  share: toSharedMemory,
  start: (pipeline) => startThread(pipeline, limits),
  explain: explainError,
});

function startThread<Message, Reply>(
  pipeline: string,
  limits: ResourceLimits | undefined,
): WorkerThread<Message, Reply> {
  const worker = new Worker(new URL('./threadWorker.js', import.meta.url), {
    workerData: pipeline,
    resourceLimits: limits,
  });
  return {
    send: (message) => worker.postMessage(message),
    listen: (hear, fail) => {
      worker.on('message', hear);
      worker.on('error', fail);
      worker.on('exit', (code) => fail(new Error(`a worker thread ended by itself, with ${code}`)));
    },
    terminate: () => worker.terminate(),
  };
}

function explainError(error: NodeJS.ErrnoException, pipelineName: LocalizedText): Error {
  const outOfMemory = error.code === 'ERR_WORKER_OUT_OF_MEMORY' || error.message.includes('allocation failed');
  if (!outOfMemory) return error;
  return unavailable(
    msg`a thread of the ${pipelineName} ran out of memory. Use fewer --threads, or let each have more: NODE_OPTIONS=--max-old-space-size=8192 [MiB]`,
  );
}
