import { SceneRenderer } from '../../../src/render/renderer.ts';
import type { Sampling } from '../../../src/render/settings.ts';
import { EYES, LIGHT, pickBoth, renderTogetherAndAlone, SCENE, SIZE } from './viewsScenes.ts';

declare global {
  interface Window {
    /** One case of viewsScenes.ts on WebGL2. */
    drawViews: (name: string) => ReturnType<typeof renderTogetherAndAlone>;
    /** What is picked, and whole channels, on WebGL2. */
    pickViews: (sampling: Sampling) => ReturnType<typeof pickBoth>;
    /** What the canvas shows of both eyes, and what is read back. */
    presentViews: () => Promise<{ readonly shown: number[]; readonly read: number[] }>;
  }
}

let renderer: SceneRenderer;
const canvas = document.createElement('canvas');

window.drawViews = async (name) => {
  renderer ??= await SceneRenderer.create({ canvas, backend: 'webgl' });
  await renderer.setScene(SCENE);
  return renderTogetherAndAlone(renderer, name, () => {});
};

window.pickViews = async (sampling) => {
  renderer ??= await SceneRenderer.create({ canvas, backend: 'webgl' });
  await renderer.setScene(SCENE);
  return pickBoth(renderer, sampling, () => {});
};

window.presentViews = async () => {
  renderer ??= await SceneRenderer.create({ canvas, backend: 'webgl' });
  await renderer.setScene(SCENE);
  renderer.setSize(SIZE.width, SIZE.height);
  const copy = new OffscreenCanvas(SIZE.width, SIZE.height).getContext('2d');
  renderer.render(EYES, LIGHT, 1);
  // In the same task: afterwards the canvas may be cleared.
  copy?.drawImage(canvas, 0, 0);
  const shown = Array.from(copy?.getImageData(0, 0, SIZE.width, SIZE.height).data ?? []);
  return { shown, read: Array.from(await renderer.readPixels()) };
};
