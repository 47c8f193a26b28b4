import { refuseLarger } from '../nodes/drawing/largest.ts';
import type { PictureRequest, Size } from '../nodes/drawing/painter.ts';
import type { AovName } from '../scene/view.ts';
import { openDevice } from './device.ts';
import { pumpFrame } from './node-shim.ts';
import type { Painter, Scenes } from './painter.ts';

/** Draws in this process, on Dawn. */
export async function openWebGpuPainter([scene, ...others]: Scenes, { width, height }: Size): Promise<Painter> {
  const gpu = await openDevice();
  // Not at the top: three looks for what the shim provides while it is being loaded.
  const { SceneRenderer } = await import('../render/renderer.ts');
  const renderer = await SceneRenderer.create({ device: gpu.device, backend: 'webgpu' });
  try {
    refuseLarger({ width, height }, renderer.info.largest);
  } catch (error) {
    renderer.dispose();
    gpu.release();
    throw error;
  }
  renderer.setSize(width, height);
  await renderer.setScene(scene, others);
  return {
    info: { pipeline: 'raster', backend: 'webgpu', adapter: gpu.adapterName },
    usualSamples: 1,
    paint: async ({ view, settings, samples, aovs, pixels: wanted }: PictureRequest) => {
      pumpFrame();
      renderer.render(view, settings, samples);
      const pixels = wanted ? await renderer.readPixels() : new Uint8Array();
      const data = new Map<AovName, Float32Array>();
      for (const name of aovs) data.set(name, await renderer.readAov(name));
      gpu.assertHealthy();
      return { pixels, aovs: data };
    },
    measure: async (view, settings) => {
      pumpFrame();
      renderer.render(view, settings);
      const gauge = await renderer.gauge();
      gpu.assertHealthy();
      return gauge;
    },
    close: async () => {
      renderer.dispose();
      gpu.release();
    },
  };
}
