import { Worker } from 'node:worker_threads';
import type { RunHeavy } from '../../graph/evaluation/evaluator.ts';
import { heavyWorkerPool } from '../../graph/evaluation/heavyWorkers.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { workerServices } from '../../nodes/services.ts';
import { openDevice } from '../gpu/device.ts';

/**
 * Evaluates heavy nodes in worker threads, which do not keep the process alive; nodes that need a GPU in this thread, because terminating a thread with an open GPU
 * ends the process.
 */
export const heavyNodes = (): RunHeavy => {
  const threads = runInThreads();
  return (request, work) => (request.onGpu ? runHere(request, work) : threads(request, work));
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
      send: (request) => {
        worker.ref();
        worker.postMessage(request);
      },
      listen: (hear, fail) => {
        worker.on('message', (reply) => {
          if (reply.kind === 'done' || reply.kind === 'failed') worker.unref();
          hear(reply);
        });
        worker.on('error', fail);
        worker.on('exit', (code) => fail(new MessageError(msg`a thread of the graph ended by itself, with ${code}`)));
      },
      end: () => void worker.terminate(),
    };
  });
