import { SceneRenderer } from '../../../src/render/renderer.ts';
import { renderSheets, type SheetLight, type SheetShade } from './movingSheetsScenes.ts';

declare global {
  interface Window {
    /** How much light shadows take from each sheet, on WebGL2. */
    captureSheets: (light: SheetLight) => Promise<SheetShade[]>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.captureSheets = async (light) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  return renderSheets(await opened, light);
};
