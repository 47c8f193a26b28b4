import { SceneRenderer } from '../../../src/render/renderer.ts';
import { NORMAL_SCENES, renderNormals } from './normalMapsScenes.ts';

declare global {
  interface Window {
    /** Renders the normals of one of the scenes on WebGL2. */
    takeNormals: (name: string) => Promise<number[]>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.takeNormals = async (name) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const scene = NORMAL_SCENES.find((candidate) => candidate.name === name);
  if (!scene) throw new Error(`no scene is called ${name}`);
  return renderNormals(await opened, scene);
};
