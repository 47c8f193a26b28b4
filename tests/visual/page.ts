import { readUsd } from '../../src/formats/usd/index.ts';
import { SceneRenderer } from '../../src/render/renderer.ts';
import type { RendererInfo } from '../../src/render/settings.ts';
import { EXTRA_SCENES } from './extraScenes.ts';
import { LATE_SCENES } from './lateScenes.ts';
import { PIECES } from './pieceScenes.ts';
import { type PixelRequest, readSamplePixels } from './pixels.ts';

declare global {
  interface Window {
    visual: {
      /** Opens an example by its file, or one of the test scenes by its name. */
      open(name: string): Promise<void>;
      /** `readSamplePixels` as base64. */
      take(request: PixelRequest): Promise<string>;
      info(): Promise<RendererInfo>;
    };
    /** Returns a file of examples/ as base64; provided by the test. */
    readExample(path: string): Promise<string>;
  }
}

const renderer = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
const made = [...EXTRA_SCENES.map(({ scene }) => scene), ...LATE_SCENES, PIECES];
const files = {
  read: async (path: string) => Uint8Array.from(atob(await window.readExample(path)), (c) => c.charCodeAt(0)),
};

window.visual = {
  async open(name) {
    await renderer.setScene(made.find((scene) => scene.name === name) ?? (await readUsd(files, name, {})));
  },
  async take(request) {
    const values = await readSamplePixels(renderer, request);
    return base64(new Uint8Array(values.buffer));
  },
  info: async () => renderer.info,
};

function base64(bytes: Uint8Array): string {
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
}
