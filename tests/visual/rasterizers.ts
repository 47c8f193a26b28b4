import '../../src/cli/gpu/nodeShim.ts';
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import type { RendererInfo } from '../../src/render/settings.ts';
import type { Scene } from '../../src/scene/types.ts';
import { openModulePage } from '../gpu/support/modulePage.ts';
import { openPictures } from '../gpu/support/openPictures.ts';
import { type PixelRequest, readSamplePixels } from './pixels.ts';

/** A rasterizer under test, with one scene at a time. */
export interface TestRasterizer {
  readonly name: 'WebGPU' | 'WebGL2';
  open(scene: Scene): Promise<void>;
  take(request: PixelRequest): Promise<Float32Array>;
  info(): Promise<RendererInfo>;
  close(): Promise<void>;
}

/** The product's renderer on Dawn, in this process. */
export async function openWebGpu(): Promise<TestRasterizer> {
  const { renderer, close } = await openPictures(16, 9);
  return {
    name: 'WebGPU',
    open: (scene) => renderer.setScene(scene),
    take: (request) => {
      pumpFrame();
      return readSamplePixels(renderer, request);
    },
    info: async () => renderer.info,
    close,
  };
}

const examples = new URL('../../examples/', import.meta.url);
const fileOf = async (path: string): Promise<string> =>
  (await readFile(fileURLToPath(new URL(path, examples)))).toString('base64');

/** The same on WebGL2, in a page of Chromium that reads the examples itself. */
export async function openWebGl(): Promise<TestRasterizer> {
  const chromium = await openModulePage(fileURLToPath(new URL('./page.ts', import.meta.url)));
  const { page } = chromium;
  await page.exposeFunction('readExample', fileOf);
  return {
    name: 'WebGL2',
    open: ({ name }) => page.evaluate((argument) => window.visual.open(argument), name),
    take: async (request) => {
      const text = await page.evaluate((argument) => window.visual.take(argument), request);
      chromium.assertHealthy();
      return new Float32Array(new Uint8Array(Buffer.from(text, 'base64')).buffer);
    },
    info: () => page.evaluate(() => window.visual.info()),
    close: () => chromium.close(),
  };
}
