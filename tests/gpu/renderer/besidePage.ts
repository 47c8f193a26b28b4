import { SceneRenderer } from '../../../src/render/renderer.ts';
import { BESIDE, type Drawn, drawAll, drawInTurns, FEW_TEXELS, FIRST, SCENE } from './besideScenes.ts';

declare global {
  interface Window {
    /** The pictures of a renderer alone, on WebGL2. */
    drawAlone: (which: 'first' | 'beside') => Promise<Drawn[]>;
    /** The pictures of two on one device, and the size of the canvas after the last of the first, and after that of the second. */
    drawBeside: () => Promise<{ readonly first: Drawn[]; readonly beside: Drawn[]; readonly canvas: number[] }>;
  }
}

const onCanvas = async (canvas: HTMLCanvasElement): Promise<SceneRenderer> => {
  const renderer = await SceneRenderer.create({ canvas, backend: 'webgl', maxPointTexels: FEW_TEXELS });
  await renderer.setScene(SCENE);
  return renderer;
};

window.drawAlone = async (which) => {
  const renderer = await onCanvas(document.createElement('canvas'));
  const drawn = await drawAll(renderer, which === 'first' ? FIRST : BESIDE, () => {});
  renderer.dispose();
  return drawn;
};

window.drawBeside = async () => {
  const canvas = document.createElement('canvas');
  const first = await onCanvas(canvas);
  const second = first.beside({ maxPointTexels: FEW_TEXELS });
  await second.setScene(SCENE);
  const drawn = await drawInTurns(first, second, () => {});
  second.dispose();
  first.dispose();
  return { ...drawn, canvas: [canvas.width, canvas.height] };
};
