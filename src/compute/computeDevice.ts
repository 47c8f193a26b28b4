import { SystemError } from '../dynamics/system.ts';
import { msg } from '../messages/message.ts';

/** A GPU for computing; call `release` when done. */
export interface ComputeGpu {
  /** The WebGPU device. */
  readonly device: GPUDevice;
  /** Whether it is a software implementation. */
  readonly software: boolean;
  /** Gives the device back; nothing computes on it afterwards. */
  release(): void;
}

/**
 * The WebGPU device of a page or worker. Throws a SystemError if there is none.
 * @example
 * const gpu = await openWebGpu();
 * try {
 *   console.log(gpu.software ? 'on the processor' : 'on a GPU');
 * } finally {
 *   gpu.release();
 * }
 */
export async function openWebGpu(): Promise<ComputeGpu> {
  const adapter = await globalThis.navigator?.gpu?.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter) throw new SystemError(msg`there is no GPU here that computes (WebGPU)`);
  const { maxBufferSize, maxStorageBufferBindingSize } = adapter.limits;
  const device = await adapter.requestDevice({ requiredLimits: { maxBufferSize, maxStorageBufferBindingSize } });
  return { device, software: adapter.info.isFallbackAdapter, release: () => device.destroy() };
}
