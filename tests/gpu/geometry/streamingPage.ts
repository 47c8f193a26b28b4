import SampleWorker from '../../../src/editor/viewport/samples.worker.ts?worker&inline';
import { SceneRenderer } from '../../../src/render/renderer.ts';
import { FEW_TEXELS, renderStreamingViews, type SampleStorage } from './streamingScenes.ts';

declare global {
  interface Window {
    /** `tolerance` [px]: of the tessellation. */
    paintStreamed: (form: SampleStorage, tolerance?: number) => Promise<number[][]>;
  }
}

window.paintStreamed = async (form, tolerance) => {
  const renderer = await SceneRenderer.create({
    canvas: document.createElement('canvas'),
    backend: 'webgl',
    ...(tolerance !== undefined && { tolerance }),
    ...(form !== 'whole' && { maxPointTexels: FEW_TEXELS }),
    ...(form === 'worker' && { sampleWorker: () => new SampleWorker() }),
  });
  const seen = await renderStreamingViews(renderer, form);
  renderer.dispose();
  return seen;
};
