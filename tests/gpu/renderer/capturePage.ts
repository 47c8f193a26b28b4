import { SceneRenderer } from '../../../src/render/renderer.ts';
import { agreement, CAPTURED, SCENE, VIEWS } from './captureScenes.ts';

declare global {
  interface Window {
    /** How far pictures from a capture are from drawn ones, on WebGL2. */
    captureAgreement: (names: readonly string[]) => ReturnType<typeof agreement>;
  }
}

window.captureAgreement = async (names) => {
  const renderer = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  await renderer.setScene(SCENE);
  // In a page, the code of captures, and that of faces, is loaded by the first picture that needs it.
  await renderer.precompile([VIEWS['0.6 c, dome']!], CAPTURED);
  return agreement(renderer, names, () => {});
};
