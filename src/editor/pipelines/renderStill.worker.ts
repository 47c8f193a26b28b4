import { messageOf } from '../../messages/messageError.ts';
import { lightOf, type StillOrder, stillRequest } from '../../nodes/still.ts';
import { openSession } from '../../pipelines/openSession.ts';
import { pipelineNamed } from '../../pipelines/registry.ts';
import { openFilmInWorker } from '../films/openFilmInWorker.ts';
import type { StillReply } from './protocol.ts';
import { workerThreads } from './workerThreads.ts';

/** Interval of progress messages [ms]. */
const PROGRESS_INTERVAL = 100;

/** Renders one picture with threads of its own, so that the page sends the scene only once. */
addEventListener('message', async ({ data }: MessageEvent<StillOrder>) => {
  try {
    const pixels = await drawStill(data);
    reply({ kind: 'done', pixels }, [pixels.buffer]);
  } catch (error) {
    reply({ kind: 'failed', message: messageOf(error) });
  }
});

async function drawStill(still: StillOrder): Promise<Float32Array<ArrayBuffer>> {
  const openGpu = () => Promise.reject(new Error('stills are drawn without a GPU'));
  const host = { threads: workerThreads, openGpu, openFilm: openFilmInWorker };
  const session = await openSession(pipelineNamed(still.pipeline), stillRequest(still), host);
  let told = 0;
  return lightOf(session, still, (part) => {
    const now = performance.now();
    if (now - told < PROGRESS_INTERVAL) return;
    told = now;
    reply({ kind: 'progress', part });
  });
}

const reply = (message: StillReply, transfer: ArrayBuffer[] = []): void => postMessage(message, { transfer });
