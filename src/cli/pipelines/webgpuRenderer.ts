import { assertPictureSize } from '../../nodes/pictures/maxSize.ts';
import type { PictureRequest, PictureSize } from '../../nodes/pictures/pictureRenderer.ts';
import type { AovName } from '../../scene/view/view.ts';
import { openDevice } from '../gpu/device.ts';
import { pumpFrame } from '../gpu/nodeShim.ts';
import type { PictureScenes, RendererSession } from './openRenderer.ts';

/** Draws in this process, on Dawn. */
export async function openWebGpuRenderer(
  [scene, ...others]: PictureScenes,
  { width, height }: PictureSize,
): Promise<RendererSession> {
  const gpu = await openDevice();
  // Not at the top: three looks for what the shim provides while it is being loaded.
  const { SceneRenderer } = await import('../../render/renderer.ts');
  const renderer = await SceneRenderer.create({ device: gpu.device, backend: 'webgpu' });
  try {
    assertPictureSize({ width, height }, renderer.info.maxTextureSize);
  } catch (error) {
    renderer.dispose();
    gpu.release();
    throw error;
  }
  renderer.setSize(width, height);
  await renderer.setScene(scene, others);
  return {
    info: { pipeline: 'raster', backend: 'webgpu', adapter: gpu.adapterName },
    defaultSamples: 1,
    render: async ({ view, settings, samples, aovs, pixels: wanted }: PictureRequest) => {
      pumpFrame();
      renderer.render(view, settings, samples);
      const pixels = wanted ? await renderer.readPixels() : new Uint8Array();
      const data = new Map<AovName, Float32Array>();
      for (const name of aovs) data.set(name, await renderer.readAov(name));
      gpu.assertHealthy();
      return { pixels, aovs: data };
    },
    measureLight: async (view, settings) => {
      pumpFrame();
      renderer.render(view, settings);
      const gauge = await renderer.measureLight();
      gpu.assertHealthy();
      return gauge;
    },
    close: async () => {
      renderer.dispose();
      gpu.release();
    },
  };
}
