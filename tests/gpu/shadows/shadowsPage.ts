import { SceneRenderer } from '../../../src/render/renderer.ts';
import { renderSunVisibility, SHADOW_SCENES } from './shadowsScenes.ts';

declare global {
  interface Window {
    /** The fraction of light that shadows leave in one of the scenes, on WebGL2. */
    captureSunVisibility: (name: string) => Promise<number[]>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.captureSunVisibility = async (name) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const scene = SHADOW_SCENES.find((candidate) => candidate.name === name);
  if (!scene) throw new Error(`no scene is called ${name}`);
  return renderSunVisibility(await opened, scene);
};
