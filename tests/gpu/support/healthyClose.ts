import type { openDevice } from '../../../src/cli/gpu/device.ts';

/** Ends a renderer on Dawn: waits for the GPU, fails on any error that it has told, and lets both go. */
export const closeAndAssertHealthy =
  (gpu: Awaited<ReturnType<typeof openDevice>>, renderer: { dispose(): void }) => async (): Promise<void> => {
    await gpu.device.queue.onSubmittedWorkDone();
    gpu.assertHealthy();
    renderer.dispose();
    gpu.release();
  };
