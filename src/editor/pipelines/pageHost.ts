import type { GpuAccess, PipelineHost } from '../../pipelines/host.ts';
import type { Backend } from '../../render/settings.ts';
import { openFilmInWorker } from '../films/openFilmInWorker.ts';
import { sampleWorker } from '../viewport/rendererWorkers.ts';
import { workerThreads } from './workerThreads.ts';

/** Renders on a device of its own, while the viewport goes on. */
export const pageHost = (backend: Backend | 'auto'): PipelineHost => ({
  openGpu: async () => openCanvas(backend),
  threads: workerThreads,
  openFilm: openFilmInWorker,
});

function openCanvas(backend: Backend | 'auto'): GpuAccess {
  const failure = new RendererFailure();
  return {
    adapterName: '',
    options: {
      canvas: document.createElement('canvas'),
      backend,
      sampleWorker,
      onError: (error) => failure.fail(error),
      onLost: (reason) => failure.fail(new Error(reason)),
    },
    // three.js updates a pass once per frame: a second picture in the same frame would repeat the first.
    nextFrame: () => new Promise((resolve) => requestAnimationFrame(resolve)),
    isShared: true,
    guard: (work) => failure.race(work),
    assertHealthy: () => {},
    release: () => {},
  };
}

/** Errors that end all work: a lost device, unreadable samples. */
class RendererFailure {
  private reject: (error: Error) => void = () => {};
  private readonly failed = new Promise<never>((_, reject) => {
    this.reject = reject;
  });

  constructor() {
    this.failed.catch(() => {});
  }

  fail(error: Error): void {
    this.reject(error);
  }

  race<T>(work: Promise<T>): Promise<T> {
    return Promise.race([work, this.failed]);
  }
}
