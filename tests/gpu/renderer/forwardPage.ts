import { readUsd } from '../../../src/formats/usd/index.ts';
import { SceneRenderer } from '../../../src/render/renderer.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { compareShadings, type ShadingComparison, SIZE } from './forwardPictures.ts';

declare global {
  interface Window {
    /** Compares pictures of an example on WebGL2. */
    compareShadings: (
      example: string,
      shots: readonly { readonly view: ViewPoint; readonly settings: RenderSettings }[],
    ) => Promise<ShadingComparison[]>;
    /** Returns a file of examples/ as base64; provided by the test. */
    readExample(path: string): Promise<string>;
  }
}

const renderer = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
renderer.setSize(SIZE.width, SIZE.height);
const files = {
  read: async (path: string) => Uint8Array.from(atob(await window.readExample(path)), (c) => c.charCodeAt(0)),
};

window.compareShadings = async (example, shots) => {
  await renderer.setScene(await readUsd(files, example, {}));
  const compared: ShadingComparison[] = [];
  for (const { view, settings } of shots) compared.push(await compareShadings(renderer, view, settings, () => {}));
  return compared;
};
