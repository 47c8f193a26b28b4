import { msg } from '../messages/message.ts';
import { MAX_VIEWS } from '../render/settings.ts';
import { AOVS, type AovName } from '../scene/view/view.ts';
import { definePipeline } from './pipeline.ts';

/** Rasterizes triangles on the past light cone on a GPU. */
export const rasterPipeline = definePipeline({
  id: 'raster',
  name: msg`rasterizer`,
  summary: msg`draws on a GPU`,
  backends: ['webgpu', 'webgl'],
  usesThreads: false,
  fixedSettings: {},
  options: {},
  aovs: (Object.keys(AOVS) as AovName[]).filter((name) => name !== 'sample_count'),
  samples: { default: 1, note: msg`smoothed by FXAA` },
  maxViews: MAX_VIEWS,
  // Imported lazily: three is large, and inspects its environment when it is imported.
  openInteractive: async (options) => (await import('./raster.gpu.ts')).openRasterRenderer(options),
});
