import { makeFilmReader } from '../../pipelines/films/makeFilmReader.ts';
import type { GpuAccess, PipelineHost } from '../../pipelines/host.ts';
import { openFfmpegFrames } from '../files/ffmpegFrames.ts';
import { nodeThreads } from './nodeThreads.ts';

/** Memory for the frames of a film: a second of 4096 × 2048 pixels [bytes]. */
const FILM_CACHE = 2 ** 30;

/** Runs pipelines in this process, on Dawn and in worker threads. */
export const nodeHost: PipelineHost = {
  openGpu: openDawn,
  threads: nodeThreads(),
  openFilm: (dome, means) => makeFilmReader(dome, means, openFfmpegFrames, FILM_CACHE),
};

/** Imported lazily: the library is large, and some machines cannot load it. */
async function openDawn(): Promise<GpuAccess> {
  const [{ openDevice }, { pumpFrame }] = await Promise.all([import('../gpu/device.ts'), import('../gpu/nodeShim.ts')]);
  const { device, adapterName, assertHealthy, release } = await openDevice();
  return {
    adapterName,
    options: { device, backend: 'webgpu' },
    nextFrame: async () => {
      // Code that a picture waits for is loaded by tasks of their own.
      await new Promise(setImmediate);
      pumpFrame();
    },
    isShared: false,
    guard: (work) => work,
    assertHealthy,
    release,
  };
}
