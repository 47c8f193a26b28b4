import { SceneRenderer } from '../../../src/render/renderer.ts';
import { LOCAL_LIGHT_SCENES, renderLight, SIZE } from './localLightShadowsScenes.ts';

declare global {
  interface Window {
    /** Renders the light of one of the scenes on WebGL2. */
    takeLight: (name: string) => Promise<number[]>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.takeLight = async (name) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const renderer = await opened;
  renderer.setSize(SIZE, SIZE);
  const scene = LOCAL_LIGHT_SCENES.find((candidate) => candidate.name === name);
  if (!scene) throw new Error(`no scene is called ${name}`);
  return renderLight(renderer, scene);
};
