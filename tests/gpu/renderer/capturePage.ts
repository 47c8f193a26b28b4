import { SceneRenderer } from '../../../src/render/renderer.ts';
import { agreement, SCENE } from './captureScenes.ts';

declare global {
  interface Window {
    /** How far pictures from a capture are from drawn ones, on WebGL2. */
    captureAgreement: (names: readonly string[]) => ReturnType<typeof agreement>;
  }
}

window.captureAgreement = async (names) => {
  const renderer = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  await renderer.setScene(SCENE);
  return agreement(renderer, names, () => {});
};
