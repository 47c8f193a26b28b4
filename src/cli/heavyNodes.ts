import { Worker } from 'node:worker_threads';
import type { RunHeavy } from '../graph/evaluate.ts';
import { heavyThreads } from '../graph/heavy.ts';

/** Has heavy nodes evaluated in threads of Node's, which do not keep the program from ending. */
export const heavyNodes = (): RunHeavy =>
  heavyThreads(() => {
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
