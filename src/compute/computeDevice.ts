import { SystemError } from '../dynamics/system.ts';

/** A GPU to compute on; `release` it at the end. */
export interface ComputeGpu {
  readonly device: GPUDevice;
  /** It is a program on the processor. */
  readonly software: boolean;
  release(): void;
}

/** The one that a page or its workers have. Throws a SystemError where there is none. */
export async function openWebGpu(): Promise<ComputeGpu> {
  const adapter = await globalThis.navigator?.gpu?.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter) throw new SystemError('there is no GPU here that computes (WebGPU)');
  const { maxBufferSize, maxStorageBufferBindingSize } = adapter.limits;
  const device = await adapter.requestDevice({ requiredLimits: { maxBufferSize, maxStorageBufferBindingSize } });
  return { device, software: adapter.info.isFallbackAdapter, release: () => device.destroy() };
}
