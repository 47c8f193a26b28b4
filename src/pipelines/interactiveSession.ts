import type { PictureViews } from '../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../scene/view/view.ts';
import type { GpuAccess } from './host.ts';
import type { InteractiveRenderer } from './interactiveRenderer.ts';
import { assertPictureSize } from './maxSize.ts';
import type { PictureRenderer, PictureRequest, RenderedPicture } from './pictureRenderer.ts';
import type { Pipeline, PipelineSession, UncheckedRequest } from './pipeline.ts';

/** Opens a session that draws single pictures with an interactive renderer. */
export async function openOnGpu(
  pipeline: Required<Pick<Pipeline, 'id' | 'openInteractive'>>,
  { scenes: [scene, ...others], size }: Pick<UncheckedRequest, 'scenes' | 'size'>,
  gpu: GpuAccess,
): Promise<PipelineSession> {
  const renderer = await pipeline.openInteractive(gpu.options);
  try {
    assertPictureSize(size, renderer.info.maxTextureSize);
  } catch (error) {
    renderer.dispose();
    gpu.release();
    throw error;
  }
  renderer.setSize(size.width, size.height);
  await renderer.setScene(scene, others);
  return {
    info: { pipeline: pipeline.id, backend: renderer.info.backend, adapter: gpu.adapterName },
    ...picturesOf(renderer, gpu),
    ...(renderer.showDome && {
      showDome: { needsMaps: true, show: (index, { maps }) => maps && renderer.showDome?.(maps, index) },
    }),
    close: async () => {
      renderer.dispose();
      gpu.release();
    },
  };
}

/** What `drawFrame` does between calls of the renderer. */
type FramePacing = Pick<GpuAccess, 'nextFrame' | 'isShared' | 'guard' | 'assertHealthy'>;

/** Renders pictures of a renderer's current scene, at its size. */
export function picturesOf(renderer: InteractiveRenderer, pacing: FramePacing): Required<PictureRenderer> {
  return {
    render: async ({
      views,
      settings,
      samples,
      pixels: needsPixels,
      aovs,
    }: PictureRequest): Promise<RenderedPicture> => {
      await drawFrame(renderer, pacing, views, settings, samples);
      const pixels = needsPixels ? await pacing.guard(renderer.readPixels()) : new Uint8Array();
      const data = new Map<AovName, Float32Array>();
      for (const name of aovs) data.set(name, await pacing.guard(renderer.readAov(name)));
      pacing.assertHealthy();
      return { pixels, aovs: data };
    },
    measureLight: async (views, settings) => {
      await drawFrame(renderer, pacing, views, settings, 1);
      const readings = await pacing.guard(renderer.measureLight());
      pacing.assertHealthy();
      return readings;
    },
  };
}

async function drawFrame(
  renderer: InteractiveRenderer,
  { nextFrame, isShared, guard }: FramePacing,
  views: PictureViews,
  settings: RenderSettings,
  samples: number,
): Promise<void> {
  await nextFrame();
  const compiling = () => (isShared ? renderer.precompile?.(views, settings, samples) : undefined);
  for (let busy = compiling(); busy; busy = compiling()) await guard(busy);
  renderer.render(views, settings, samples);
  while (renderer.info.waiting) {
    await guard(nextFrame());
    renderer.render(views, settings, samples);
  }
}
