import { SceneRenderer } from '../../../src/render/renderer.ts';
import { type SeenPoint, SIZE, type SkyFlight, seenPoints } from './movingSkyScenes.ts';

declare global {
  interface Window {
    /** What is seen of a flying body under a sky, on WebGL2. */
    seenPoints: (flight: SkyFlight) => Promise<SeenPoint[]>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.seenPoints = async (flight) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const renderer = await opened;
  renderer.setSize(SIZE, SIZE);
  return seenPoints(renderer, flight);
};
