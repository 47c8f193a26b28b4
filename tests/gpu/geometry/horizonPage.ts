import { SceneRenderer } from '../../../src/render/renderer.ts';
import { drawHorizon } from './horizonScenes.ts';

declare global {
  interface Window {
    /** A case of horizonScenes.ts on WebGL2. */
    drawHorizon: (name: string) => ReturnType<typeof drawHorizon>;
  }
}

let renderer: SceneRenderer;

window.drawHorizon = async (name) => {
  renderer ??= await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  return drawHorizon(renderer, name, () => {});
};
