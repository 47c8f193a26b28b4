import '../../../src/cli/gpu/nodeShim.ts';
import { type HeadlessDevice, openDevice } from '../../../src/cli/gpu/device.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import type { RendererOptions } from '../../../src/render/settings.ts';
import { closeAndAssertHealthy } from './healthyClose.ts';

export interface HeadlessPictures {
  readonly renderer: SceneRenderer;
  readonly gpu: HeadlessDevice;
  /** Throws errors reported by the GPU, and releases it. */
  close(): Promise<void>;
}

/** The product's renderer on Dawn, in Node. */
export async function openPictures(
  width: number,
  height: number,
  options: RendererOptions = {},
): Promise<HeadlessPictures> {
  const gpu = await openDevice();
  // After the shim, which three.js requires when it is loaded.
  const { SceneRenderer } = await import('../../../src/render/renderer.ts');
  const renderer = await SceneRenderer.create({ ...options, device: gpu.device });
  renderer.setSize(width, height);
  return {
    renderer,
    gpu,
    close: closeAndAssertHealthy(gpu, renderer),
  };
}
