import { type LocalizedText, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { RAISED_LIMITS } from '../../render/gpu/deviceLimits.ts';
import { isSoftwareGpu } from '../../render/gpu/softwareGpu.ts';
import { unavailable } from '../terminal/exitCodes.ts';
import { findSwiftShader, hasVulkanDriver } from './gpuDrivers.ts';

/** Dawn, Chromium's WebGPU implementation, for Node. */
type Dawn = typeof import('webgpu');

/** An open WebGPU device. Its Dawn objects are retained until `release`, because collecting one of them aborts the process. */
export interface HeadlessDevice {
  readonly device: GPUDevice;
  readonly adapterName: string;
  readonly software: boolean;
  /** Throws the first error that the device has reported since it was opened; Dawn itself only logs errors. */
  assertHealthy(): void;
  release(): void;
}

const retained = new Set<unknown>();

const optionalFeatures: readonly GPUFeatureName[] = [
  'float32-filterable',
  'float32-blendable',
  'timestamp-query',
  'rg11b10ufloat-renderable',
  'depth32float-stencil8',
  'indirect-first-instance',
];
/** Opens a GPU without a window, or SwiftShader from a Chromium installation if there is none. */
export async function openDevice(): Promise<HeadlessDevice> {
  const dawn = await loadDawn();
  Object.assign(globalThis, dawn.globals);
  const { gpu, adapter } = await findAdapter(dawn);
  const device = await adapter.requestDevice({
    requiredFeatures: optionalFeatures.filter((feature) => adapter.features.has(feature)),
    requiredLimits: Object.fromEntries(RAISED_LIMITS.map((name) => [name, adapter.limits[name]])),
  });
  retained.add(gpu).add(adapter).add(device);
  const errors = recordErrors(device);
  return {
    device,
    adapterName: adapter.info.description || adapter.info.device || adapter.info.vendor,
    software: adapter.info.isFallbackAdapter || isSoftwareGpu(adapter.info.description),
    assertHealthy: () => {
      if (errors.length > 0) throw new MessageError(msg`the GPU reported: ${errors[0] ?? ''}`);
    },
    release: () => {
      device.destroy();
      for (const object of [gpu, adapter, device]) retained.delete(object);
    },
  };
}

/** Imported lazily, so that everything else works on machines that the library does not support. */
async function loadDawn(): Promise<Dawn> {
  try {
    return await import('webgpu');
  } catch (error) {
    throw unavailable(msg`the GPU library (npm package webgpu) does not load here: ${String(error)}`);
  }
}

async function findAdapter(dawn: Dawn): Promise<{ gpu: GPU; adapter: GPUAdapter }> {
  if (hasVulkanDriver()) {
    const found = await askForAdapter(dawn);
    if (found) return found;
  }
  const driver = process.env.VK_ICD_FILENAMES ? undefined : findSwiftShader();
  if (driver) {
    process.env.VK_ICD_FILENAMES = driver;
    const found = await askForAdapter(dawn);
    if (found) return found;
  }
  throw unavailable(
    msg`no GPU was found, and no software one. On Debian or Ubuntu: apt-get install -y chromium libvulkan1 (Chromium carries the software GPU). Elsewhere set VK_ICD_FILENAMES to the description of a Vulkan driver, or use --backend webgl.`,
  );
}

async function askForAdapter(dawn: Dawn): Promise<{ gpu: GPU; adapter: GPUAdapter } | undefined> {
  const gpu = dawn.create([]);
  retained.add(gpu);
  const adapter = await gpu.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter) retained.delete(gpu);
  return adapter ? { gpu, adapter } : undefined;
}

function recordErrors(device: GPUDevice): readonly LocalizedText[] {
  const errors: LocalizedText[] = [];
  device.addEventListener('uncapturederror', (event) => {
    errors.push((event as GPUUncapturedErrorEvent).error.message);
    event.preventDefault();
  });
  void device.lost.then((info) => {
    if (info.reason !== 'destroyed') errors.push(msg`the device was lost: ${info.message}`);
  });
  return errors;
}
