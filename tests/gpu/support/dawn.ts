import '../../../src/cli/gpu/nodeShim.ts';
import { WebGPURenderer } from 'three/webgpu';
import { type HeadlessDevice, openDevice } from '../../../src/cli/gpu/device.ts';
import { closeAndAssertHealthy } from './healthyClose.ts';

export interface HeadlessRenderer {
  readonly renderer: WebGPURenderer;
  readonly gpu: HeadlessDevice;
  /** Throws errors reported by the GPU, and releases it. */
  close(): Promise<void>;
}

/** three's renderer on Dawn, in Node. */
export async function openRenderer(): Promise<HeadlessRenderer> {
  const gpu = await openDevice();
  const renderer = new WebGPURenderer({ canvas: canvas(), device: gpu.device });
  await renderer.init();
  return {
    renderer,
    gpu,
    close: closeAndAssertHealthy(gpu, renderer),
  };
}

/** The renderer requires one; nothing is drawn on it. */
const canvas = (): HTMLCanvasElement =>
  ({ width: 1, height: 1, style: {}, addEventListener() {}, removeEventListener() {} }) as unknown as HTMLCanvasElement;
