import { SceneRenderer } from '../../../src/render/renderer.ts';
import { EYES, LIGHT, renderTogetherAndAlone, SCENE, SIZE } from './viewsScenes.ts';

declare global {
  interface Window {
    /** One case of viewsScenes.ts on WebGL2. */
    drawViews: (name: string) => ReturnType<typeof renderTogetherAndAlone>;
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
