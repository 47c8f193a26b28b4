import { SceneRenderer } from '../../../src/render/renderer.ts';
import { middleLight } from './lightRangeScenes.ts';

type Arguments = Parameters<typeof middleLight> extends [unknown, ...infer Rest, unknown] ? Rest : never;

declare global {
  interface Window {
    /** `middleLight` on WebGL2. */
    middleLight: (...given: Arguments) => ReturnType<typeof middleLight>;
  }
}

let renderer: SceneRenderer;

window.middleLight = async (...given) => {
  renderer ??= await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  await renderer.loadFrameGraphs();
  return middleLight(renderer, ...given, () => {});
};
