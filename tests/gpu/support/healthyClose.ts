import type { openDevice } from '../../../src/cli/gpu/device.ts';

/** Closes a renderer on Dawn: waits for the GPU, throws on any reported error, and releases both. */
export const closeAndAssertHealthy =
  (gpu: Awaited<ReturnType<typeof openDevice>>, renderer: { dispose(): void }) => async (): Promise<void> => {
    await gpu.device.queue.onSubmittedWorkDone();
    gpu.assertHealthy();
    renderer.dispose();
    gpu.release();
  };
