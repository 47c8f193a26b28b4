import { Worker } from 'node:worker_threads';
import type { RunHeavy } from '../../graph/evaluation/evaluator.ts';
import { heavyWorkerPool } from '../../graph/evaluation/heavyWorkers.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { workerServices } from '../../nodes/services.ts';
import { openDevice } from '../gpu/device.ts';

/** Has heavy nodes evaluated in threads of Node's, which do not keep the program from ending; but here, where they need a GPU: to end a thread that has one ends the program. */
export const heavyNodes = (): RunHeavy => {
  const threads = runInThreads();
  return (order, work) => (order.onGpu ? runHere(order, work) : threads(order, work));
};

const runHere: RunHeavy = async ({ type, node, inputs, params, resume }, { signal, progress }) =>
  nodeLibrary[type]!.evaluate(inputs, params, {
    ...{ services: { ...workerServices, openGpu: openDevice }, progress, node },
    ...(signal && { signal }),
    ...(resume && { resume }),
  });

const runInThreads = (): RunHeavy =>
  heavyWorkerPool(() => {
    const worker = new Worker(new URL('./heavyNodeWorker.js', import.meta.url));
    return {
      send: (order) => {
        worker.ref();
        worker.postMessage(order);
      },
      listen: (hear, fail) => {
        worker.on('message', (reply) => {
          if (reply.kind === 'done' || reply.kind === 'failed') worker.unref();
          hear(reply);
        });
        worker.on('error', fail);
        worker.on('exit', (code) => fail(new Error(`a thread of the graph ended by itself, with ${code}`)));
      },
      end: () => void worker.terminate(),
    };
  });
