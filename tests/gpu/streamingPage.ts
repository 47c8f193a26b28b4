import { SceneRenderer } from '../../src/render/renderer.ts';
import { FEW_TEXELS, type Form, paintLooks } from './streamingScenes.ts';

declare global {
  interface Window {
    paintStreamed: (form: Form) => Promise<number[][]>;
  }
}

window.paintStreamed = async (form) => {
  const canvas = document.createElement('canvas');
  const few = form === 'whole' ? {} : { pointTexels: FEW_TEXELS };
  const renderer = await SceneRenderer.create({ canvas, backend: 'webgl', ...few });
  const seen = await paintLooks(renderer, form);
  renderer.dispose();
  return seen;
};
