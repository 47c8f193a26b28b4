import { SceneRenderer } from '../../../src/render/renderer.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { type Data, readData } from '../support/readData.ts';
import { DEPTH_SCENES } from './depthScenes.ts';

declare global {
  interface Window {
    /** Renders one of the scenes on WebGL2, `size` pixels high and wide. */
    renderDepth: (
      name: string,
      view: ViewPoint,
      settings: RenderSettings,
      size: number,
      clipControl: boolean,
    ) => Promise<Data>;
  }
}

const opened = new Map<boolean, Promise<SceneRenderer>>();

window.renderDepth = async (name, view, settings, size, clipControl) => {
  if (!opened.has(clipControl)) opened.set(clipControl, open(clipControl));
  const renderer = await opened.get(clipControl);
  const scene = DEPTH_SCENES.find((candidate) => candidate.name === name);
  if (!renderer || !scene) throw new Error(`no scene is called ${name}`);
  renderer.setSize(size, size);
  await renderer.setScene(scene);
  const data = await readData(renderer, view, settings);
  const plain = Object.entries(data).map(([aov, values]) => [aov, Array.from(values)]);
  return Object.fromEntries(plain) as Data;
};

/** Hides EXT_clip_control, as on devices without it. */
async function open(clipControl: boolean): Promise<SceneRenderer> {
  const contexts = WebGL2RenderingContext.prototype;
  const { getExtension, getSupportedExtensions } = contexts;
  const hidden = (name: string): boolean => !clipControl && name === 'EXT_clip_control';
  Object.assign(contexts, {
    getExtension(this: WebGL2RenderingContext, name: string): unknown {
      return hidden(name) ? null : Reflect.apply(getExtension, this, [name]);
    },
    getSupportedExtensions(this: WebGL2RenderingContext) {
      return getSupportedExtensions.call(this)?.filter((name) => !hidden(name));
    },
  });
  const renderer = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  Object.assign(contexts, { getExtension, getSupportedExtensions });
  return renderer;
}
