import { SceneRenderer } from '../../../src/render/renderer.ts';
import { type Flight, type SeenPoint, SIZE, seenPoints } from './movingSkyScenes.ts';

declare global {
  interface Window {
    /** What is seen of a flying body under a sky, on WebGL2. */
    seenPoints: (flight: Flight) => Promise<SeenPoint[]>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.seenPoints = async (flight) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const renderer = await opened;
  renderer.setSize(SIZE, SIZE);
  return seenPoints(renderer, flight);
};
