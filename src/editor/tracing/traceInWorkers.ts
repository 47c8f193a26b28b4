import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { queueTraces, type ReferenceTrace } from '../../nodes/trace.ts';
import type { TraceReply, TraceRequest } from './protocol.ts';

/** Debounces slider steps, so that only the last is traced [ms]. */
const DEBOUNCE = 200;

/** Traces pictures with the reference renderer in workers, which are terminated on cancellation. */
export const traceInWorkers: ReferenceTrace = queueTraces(async (scene, picture, { signal, progress }) => {
  progress(0, 'trace');
  await new Promise((done) => setTimeout(done, DEBOUNCE));
  if (signal?.aborted) throw new CancelledError();
  const worker = new Worker(new URL('./tracePicture.worker.ts', import.meta.url), { type: 'module' });
  const traced = new Promise<Float32Array<ArrayBuffer>>((resolve, reject) => {
    signal?.addEventListener('abort', () => reject(new CancelledError()));
    worker.addEventListener('error', ({ message }) => reject(new Error(message || 'a worker could not be started')));
    worker.addEventListener('message', ({ data }: MessageEvent<TraceReply>) => {
      if (data.kind === 'progress') progress(data.part, 'trace');
      else if (data.kind === 'failed') reject(new Error(data.message));
      else resolve(data.pixels);
    });
    const order: TraceRequest = { scene, picture };
    worker.postMessage(order);
  });
  return traced.finally(() => worker.terminate());
});
