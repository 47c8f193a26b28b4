import { transferables } from '../../graph/evaluation/transferables.ts';
import { prepareScene } from '../../reference/intersection/tracedScene.ts';
import { renderWithPool, TracerPool, type TracerThread, tilesOf } from '../../reference/tracerPool.ts';
import type { Scene } from '../../scene/types.ts';
import type { TraceReply, TraceRequest } from './protocol.ts';

/** Memory limit for the tracers' copies of the scene, together [bytes]. */
const MAX_SCENE_COPIES_BYTES = 2 ** 30;
/** Memory for cached shapes of sampled objects, of all tracers [bytes]. */
const SHAPE_CACHE_BYTES = 2 ** 29;
/** Interval of progress messages [ms]. */
const PROGRESS_INTERVAL = 100;

/** Traces one picture with workers of its own, so that the page sends the scene only once. */
addEventListener('message', async ({ data }: MessageEvent<TraceRequest>) => {
  try {
    const pixels = await tracePicture(data);
    reply({ kind: 'done', pixels }, [pixels.buffer]);
  } catch (error) {
    reply({ kind: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
});

async function tracePicture({ scene, picture }: TraceRequest): Promise<Float32Array<ArrayBuffer>> {
  const count = Math.min(threadsFor(scene), tilesOf(picture).length);
  const ground = prepareScene(scene, picture.settings.speedOfLight);
  const threads = Array.from({ length: count }, startTracer);
  const pool = new TracerPool(threads, { kind: 'scene', ground, shapes: SHAPE_CACHE_BYTES / count });
  let told = 0;
  const layers = await renderWithPool(pool, { ...picture, layers: ['beauty'] }, (part) => {
    const now = performance.now();
    if (now - told < PROGRESS_INTERVAL) return;
    told = now;
    reply({ kind: 'progress', part });
  });
  return layers.get('beauty')!;
}

/** One core is left to the page; large scenes get fewer copies. */
function threadsFor(scene: Scene): number {
  const bytes = transferables(scene).reduce((sum, { byteLength }) => sum + byteLength, 1);
  return Math.max(1, Math.min(navigator.hardwareConcurrency - 1, Math.floor(MAX_SCENE_COPIES_BYTES / bytes)));
}

function startTracer(): TracerThread {
  const worker = new Worker(new URL('./traceTiles.worker.ts', import.meta.url), { type: 'module' });
  return {
    send: (order) => worker.postMessage(order),
    listen: (hear, fail) => {
      worker.addEventListener('message', ({ data }) => hear(data));
      worker.addEventListener('error', ({ message }) => fail(new Error(message || 'a worker could not be started')));
    },
    terminate: () => {
      worker.terminate();
      return undefined;
    },
  };
}

const reply = (message: TraceReply, transfer: ArrayBuffer[] = []): void => postMessage(message, { transfer });
