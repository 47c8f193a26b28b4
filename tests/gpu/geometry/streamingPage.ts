import SampleWorker from '../../../src/editor/viewport/samples.worker.ts?worker&inline';
import { SceneRenderer } from '../../../src/render/renderer.ts';
import { FEW_TEXELS, renderStreamingPair, renderStreamingViews, type SampleStorage } from './streamingScenes.ts';

declare global {
  interface Window {
    /** `tolerance` [px]: of the tessellation. */
    paintStreamed: (form: SampleStorage, tolerance?: number) => Promise<number[][]>;
    /** Two views in one picture, uncut. */
    paintStreamedPair: (form: SampleStorage) => Promise<number[]>;
  }
}

const rendererFor = (form: SampleStorage, tolerance?: number): Promise<SceneRenderer> =>
  SceneRenderer.create({
    canvas: document.createElement('canvas'),
    backend: 'webgl',
    ...(tolerance !== undefined && { tolerance }),
    ...(form !== 'whole' && { maxPointTexels: FEW_TEXELS }),
    ...(form === 'worker' && { sampleWorker: () => new SampleWorker() }),
  });

window.paintStreamed = async (form, tolerance) => {
  const renderer = await rendererFor(form, tolerance);
  const seen = await renderStreamingViews(renderer, form);
  renderer.dispose();
  return seen;
};

window.paintStreamedPair = async (form) => {
  const renderer = await rendererFor(form, Number.POSITIVE_INFINITY);
  const seen = await renderStreamingPair(renderer, form);
  renderer.dispose();
  return seen;
};
