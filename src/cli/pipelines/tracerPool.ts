import { type ResourceLimits, Worker } from 'node:worker_threads';
import { prepareScene } from '../../reference/intersection/tracedScene.ts';
import { TracerPool, type TracerThread } from '../../reference/tracerPool.ts';
import type { Scene } from '../../scene/types.ts';
import { unavailable } from '../terminal/exitCodes.ts';
import { toSharedMemory } from './sharedMemory.ts';

/** Memory for the shapes of sampled objects at their samples: of all threads, and of one [bytes]. */
const [SHAPES, MOST_SHAPES] = [4 * 2 ** 30, 256 * 2 ** 20];

export interface PoolOptions {
  readonly threads: number;
  /** Of each thread; Node's own where absent. */
  readonly limits?: ResourceLimits;
}

/** Threads of Node's that draw pictures of a scene at one speed of light [m/s]. They share what it is made of. */
export function tracerPool(scene: Scene, speedOfLight: number, { threads, limits }: PoolOptions): TracerPool {
  const ground = toSharedMemory(prepareScene(scene, speedOfLight));
  const shapes = Math.min(MOST_SHAPES, SHAPES / threads);
  const started = Array.from({ length: threads }, () => tracerThread(limits));
  return new TracerPool(started, { kind: 'scene', ground, shapes }, explainError);
}

function tracerThread(limits: ResourceLimits | undefined): TracerThread {
  const worker = new Worker(new URL('./tracerWorker.js', import.meta.url), { resourceLimits: limits });
  return {
    send: (order) => worker.postMessage(order),
    listen: (hear, fail) => {
      worker.on('message', hear);
      worker.on('error', fail);
      worker.on('exit', (code) => fail(new Error(`a worker thread ended by itself, with ${code}`)));
    },
    terminate: () => worker.terminate(),
  };
}

function explainError(error: NodeJS.ErrnoException): Error {
  const outOfMemory = error.code === 'ERR_WORKER_OUT_OF_MEMORY' || error.message.includes('allocation failed');
  if (!outOfMemory) return error;
  return unavailable(
    'a thread of the reference renderer ran out of memory. Use fewer --threads, or let each have more: NODE_OPTIONS=--max-old-space-size=8192 [MiB]',
  );
}
