import { transferables } from '../../graph/transfer.ts';
import { drawnBy, TracerPool, type TracerThread, tilesOf } from '../../reference/pool.ts';
import { groundwork } from '../../reference/trace.ts';
import type { Scene } from '../../scene/types.ts';
import type { TraceOrder, TraceReply } from './protocol.ts';

/** Each tracer has its own copy of the scene; so much memory they take together at most [bytes]. */
const COPIES = 2 ** 30;
/** Memory for the shapes of sampled objects at their samples, of all tracers [bytes]. */
const SHAPES = 2 ** 29;
/** Between two words on how far it is [ms]. */
const INTERVAL = 100;

/** Has one picture traced by workers of its own, so that the page only sends the scene once. */
addEventListener('message', async ({ data }: MessageEvent<TraceOrder>) => {
  try {
    const pixels = await traced(data);
    reply({ kind: 'done', pixels }, [pixels.buffer]);
  } catch (error) {
    reply({ kind: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
});

async function traced({ scene, picture }: TraceOrder): Promise<Float32Array<ArrayBuffer>> {
  const count = Math.min(threadsFor(scene), tilesOf(picture).length);
  const ground = groundwork(scene, picture.settings.speedOfLight);
  const threads = Array.from({ length: count }, tracer);
  const pool = new TracerPool(threads, { kind: 'scene', ground, shapes: SHAPES / count });
  let told = 0;
  const layers = await drawnBy(pool, { ...picture, layers: ['beauty'] }, (part) => {
    const now = performance.now();
    if (now - told < INTERVAL) return;
    told = now;
    reply({ kind: 'progress', part });
  });
  return layers.get('beauty')!;
}

/** One processor is left to the page; of large scenes there are fewer copies. */
function threadsFor(scene: Scene): number {
  const bytes = transferables(scene).reduce((sum, { byteLength }) => sum + byteLength, 1);
  return Math.max(1, Math.min(navigator.hardwareConcurrency - 1, Math.floor(COPIES / bytes)));
}

function tracer(): TracerThread {
  const worker = new Worker(new URL('./tracer.worker.ts', import.meta.url), { type: 'module' });
  return {
    send: (order) => worker.postMessage(order),
    listen: (hear, fail) => {
      worker.addEventListener('message', ({ data }) => hear(data));
      worker.addEventListener('error', ({ message }) => fail(new Error(message || 'a worker could not be started')));
    },
    end: () => {
      worker.terminate();
      return undefined;
    },
  };
}

const reply = (message: TraceReply, transfer: ArrayBuffer[] = []): void => postMessage(message, { transfer });
