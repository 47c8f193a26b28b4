import { SceneRenderer } from '../../../src/render/renderer.ts';
import { type CornerMotion, cornerPicture, floorOf, HEIGHT, WIDTH } from './occlusionScenes.ts';

declare global {
  interface Window {
    /** Distances of floor points from a wall, and their unoccluded fraction of the sky, on WebGL2. */
    floorOf: (flight: CornerMotion) => Promise<[number, number][]>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.floorOf = async (flight) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const renderer = await opened;
  renderer.setSize(WIDTH, HEIGHT);
  return floorOf(renderer, cornerPicture(flight));
};
