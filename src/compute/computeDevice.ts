import { SystemError } from '../dynamics/system.ts';

/** A GPU for computing; call `release` when done. */
export interface ComputeGpu {
  readonly device: GPUDevice;
  /** Whether it is a software implementation. */
  readonly software: boolean;
  release(): void;
}

/** The WebGPU device of a page or worker. Throws a SystemError if there is none. */
export async function openWebGpu(): Promise<ComputeGpu> {
  const adapter = await globalThis.navigator?.gpu?.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter) throw new SystemError('there is no GPU here that computes (WebGPU)');
  const { maxBufferSize, maxStorageBufferBindingSize } = adapter.limits;
  const device = await adapter.requestDevice({ requiredLimits: { maxBufferSize, maxStorageBufferBindingSize } });
  return { device, software: adapter.info.isFallbackAdapter, release: () => device.destroy() };
}
