import { MAX_VIEWS } from '../render/settings.ts';
import { AOVS, type AovName } from '../scene/view/view.ts';
import { definePipeline } from './pipeline.ts';

/** Triangles on a GPU, where the light cone meets them. */
export const rasterPipeline = definePipeline({
  id: 'raster',
  name: 'rasterizer',
  summary: 'draws on a GPU',
  backends: ['webgpu', 'webgl'],
  usesThreads: false,
  fixedSettings: {},
  options: {},
  aovs: Object.keys(AOVS) as AovName[],
  samples: { default: 1, note: 'whose edges FXAA then smooths' },
  maxViews: MAX_VIEWS,
  // Loaded when it is opened: three is large, and looks around it while it is loaded.
  openInteractive: async (options) => (await import('./raster.gpu.ts')).openRasterRenderer(options),
});
