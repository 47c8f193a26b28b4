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
    /** How many programs the first picture of the last shot without a G-buffer links, whose shaders were compiled while the others were drawn with one; and how many were compiled. */
    linkLate: (
      example: string,
      shots: readonly { readonly view: ViewPoint; readonly settings: RenderSettings }[],
    ) => Promise<{ readonly late: number; readonly ahead: number }>;
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

window.linkLate = async (example, shots) => {
  let linked = 0;
  const { linkProgram } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.linkProgram = function (program) {
    linked++;
    linkProgram.call(this, program);
  };
  const last = shots[shots.length - 1]!;
  await renderer.setScene(await readUsd(files, example, {}));
  const draw = (shading: 'auto' | 'deferred', { view, settings }: (typeof shots)[number]) => {
    renderer.shading = shading;
    renderer.render([view], settings);
    renderer.shading = 'auto';
  };
  draw('deferred', shots[0]!);
  const before = linked;
  let compiling = renderer.precompile([shots[0]!.view], shots[0]!.settings);
  for (let i = 0; compiling; i++) {
    draw('deferred', shots[i % shots.length]!);
    await Promise.race([compiling, new Promise((frame) => setTimeout(frame))]);
    compiling = renderer.precompile([shots[0]!.view], shots[0]!.settings);
  }
  const ahead = linked - before;
  draw('auto', last);
  WebGL2RenderingContext.prototype.linkProgram = linkProgram;
  return { late: linked - before - ahead, ahead };
};
