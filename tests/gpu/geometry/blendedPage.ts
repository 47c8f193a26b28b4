import { SceneRenderer } from '../../../src/render/renderer.ts';
import { renderForms } from './blendedScenes.ts';

declare global {
  interface Window {
    paintSkins: () => Promise<number[][][][]>;
  }
}

window.paintSkins = async () => {
  const renderer = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const seen = await renderForms(renderer);
  renderer.dispose();
  return seen;
};
