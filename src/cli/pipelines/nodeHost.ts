import type { GpuAccess, PipelineHost } from '../../pipelines/host.ts';
import { nodeThreads } from './nodeThreads.ts';

/** Pipelines draw in this process: on Dawn, and in threads of Node's. */
export const nodeHost: PipelineHost = { openGpu: openDawn, threads: nodeThreads() };

/** Loaded when it is needed: it brings a large library, and some machines cannot load it. */
async function openDawn(): Promise<GpuAccess> {
  const [{ openDevice }, { pumpFrame }] = await Promise.all([import('../gpu/device.ts'), import('../gpu/nodeShim.ts')]);
  const { device, adapterName, assertHealthy, release } = await openDevice();
  return {
    adapterName,
    options: { device, backend: 'webgpu' },
    nextFrame: async () => pumpFrame(),
    isShared: false,
    guard: (work) => work,
    assertHealthy,
    release,
  };
}
