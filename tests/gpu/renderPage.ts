import { SceneRenderer } from '../../src/render/renderer.ts';
import type { RenderSettings, ViewPoint } from '../../src/scene/view.ts';
import { type Data, readData } from './readData.ts';
import { SCENES } from './renderScenes.ts';

declare global {
  interface Window {
    /** Renders one of the test scenes on WebGL2. */
    renderScene: (
      name: string,
      view: ViewPoint,
      settings: RenderSettings,
      width: number,
      height: number,
    ) => Promise<Data>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.renderScene = async (name, view, settings, width, height) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const renderer = await opened;
  const scene = SCENES.find((candidate) => candidate.name === name);
  if (!scene) throw new Error(`no scene is called ${name}`);
  if (renderer.width !== width) renderer.setSize(width, height);
  await renderer.setScene(scene);
  const { object, position, emission_time, doppler, velocity, depth } = await readData(renderer, view, settings);
  return {
    object: Array.from(object),
    position: Array.from(position),
    emission_time: Array.from(emission_time),
    doppler: Array.from(doppler),
    velocity: Array.from(velocity),
    depth: Array.from(depth),
  };
};
