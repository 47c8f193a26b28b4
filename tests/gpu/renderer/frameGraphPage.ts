import { SceneRenderer } from '../../../src/render/renderer.ts';
import type { AovName } from '../../../src/scene/view/view.ts';
import { type RenderedFrameGraph, renderFrameGraph, renderStillImages } from './frameGraphScenes.ts';

declare global {
  interface Window {
    /** The frame graph of frameGraphScenes.ts on WebGL2, and its inputs. */
    drawPlan: (needed: readonly (readonly AovName[])[]) => Promise<RenderedFrameGraph>;
    /** Stills on WebGL2. */
    drawStills: () => Promise<number[][]>;
  }
}

async function renderer(): Promise<SceneRenderer> {
  const made = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  await made.loadFrameGraphs();
  return made;
}

window.drawPlan = async (needed) => renderFrameGraph(await renderer(), needed);
window.drawStills = async () => renderStillImages(await renderer());
