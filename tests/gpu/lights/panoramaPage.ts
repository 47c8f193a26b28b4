import { SceneRenderer } from '../../../src/render/renderer.ts';
import { drawnPanorama, H, type PanoramaFlight, W } from './panoramaScenes.ts';

declare global {
  interface Window {
    /** A picture of a panorama on WebGL2. */
    drawnPanorama: (flight: PanoramaFlight) => Promise<number[]>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.drawnPanorama = async (flight) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const renderer = await opened;
  renderer.setSize(W, H);
  return drawnPanorama(renderer, flight);
};
