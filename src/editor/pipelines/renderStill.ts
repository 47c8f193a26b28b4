import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { MessageError } from '../../messages/messageError.ts';
import { queueStills, type RenderStill } from '../../nodes/still.ts';
import type { StillReply } from './protocol.ts';
import { workerError } from './workerError.ts';

/** Debounces slider steps, so that only the last is rendered [ms]. */
const DEBOUNCE = 200;

/** Renders stills in workers, which are terminated on cancellation. */
export const renderStillInWorker: RenderStill = queueStills(async (still, { signal, progress }) => {
  progress(0, 'trace');
  await new Promise((done) => setTimeout(done, DEBOUNCE));
  if (signal?.aborted) throw new CancelledError();
  const worker = new Worker(new URL('./renderStill.worker.ts', import.meta.url), { type: 'module' });
  const drawn = new Promise<Float32Array<ArrayBuffer>>((resolve, reject) => {
    signal?.addEventListener('abort', () => reject(new CancelledError()));
    worker.addEventListener('error', ({ message }) => reject(workerError(message)));
    worker.addEventListener('message', ({ data }: MessageEvent<StillReply>) => {
      if (data.kind === 'progress') progress(data.part, 'trace');
      else if (data.kind === 'failed') reject(new MessageError(data.message));
      else resolve(data.pixels);
    });
    worker.postMessage(still);
  });
  return drawn.finally(() => worker.terminate());
});
