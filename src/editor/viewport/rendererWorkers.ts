/** Plans the tessellation of pictures. */
export const tessellationWorker = (): Worker =>
  new Worker(new URL('./tessellation.worker.ts', import.meta.url), { type: 'module' });

/** Reads samples of motions from files. */
export const sampleWorker = (): Worker =>
  new Worker(new URL('./samples.worker.ts', import.meta.url), { type: 'module' });
