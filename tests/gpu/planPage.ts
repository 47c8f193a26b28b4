import { SceneRenderer } from '../../src/render/renderer.ts';
import type { AovName } from '../../src/scene/view.ts';
import { type Drawn, drawPlan, drawStills } from './planScenes.ts';

declare global {
  interface Window {
    /** The plan of planScenes.ts on WebGL2, and what it is made of. */
    drawPlan: (needed: readonly (readonly AovName[])[]) => Promise<Drawn>;
    /** Stills on WebGL2. */
    drawStills: () => Promise<number[][]>;
  }
}

const renderer = () => SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });

window.drawPlan = async (needed) => drawPlan(await renderer(), needed);
window.drawStills = async () => drawStills(await renderer());
