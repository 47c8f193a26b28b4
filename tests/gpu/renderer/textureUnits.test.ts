import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { openModulePage } from '../support/modulePage.ts';
import { openPictures } from '../support/openPictures.ts';
import { fullPicture, SIZE } from './textureUnitsScene.ts';

/** Textures that WebGPU and WebGL2 promise to the fragments of one shader. */
const EVERY_DEVICE = 16;
/** What the largest shaders take of them: a new table belongs in the atlas or the scene's float table, not in a texture of its own. */
const MOST = 13;

/** How many textures the fragments of each kind of shader read, as pipelines are made for them. */
function countTextures(device: GPUDevice): Map<string, number> {
  const counts = new Map<string, number>();
  const groups = new WeakMap<object, number>();
  const layouts = new WeakMap<object, number>();
  const { createBindGroupLayout, createPipelineLayout, createRenderPipeline, createRenderPipelineAsync } = device;
  device.createBindGroupLayout = (descriptor) => {
    const made = createBindGroupLayout.call(device, descriptor);
    const read = [...descriptor.entries].filter(
      ({ texture, visibility }) => texture && visibility & GPUShaderStage.FRAGMENT,
    );
    groups.set(made, read.length);
    return made;
  };
  device.createPipelineLayout = (descriptor) => {
    const made = createPipelineLayout.call(device, descriptor);
    const all = [...descriptor.bindGroupLayouts].map((group) => (group && groups.get(group)) ?? 0);
    layouts.set(
      made,
      all.reduce((a, b) => a + b, 0),
    );
    return made;
  };
  const noted = (descriptor: GPURenderPipelineDescriptor): void => {
    const name = (descriptor.label ?? '').replace(/^renderPipeline_|_\d+$/g, '');
    const layout = descriptor.layout === 'auto' ? undefined : layouts.get(descriptor.layout);
    counts.set(name, Math.max(layout ?? 0, counts.get(name) ?? 0));
  };
  device.createRenderPipeline = (descriptor) => {
    noted(descriptor);
    return createRenderPipeline.call(device, descriptor);
  };
  device.createRenderPipelineAsync = (descriptor) => {
    noted(descriptor);
    return createRenderPipelineAsync.call(device, descriptor);
  };
  return counts;
}

/** How far apart two pictures are, over the mean of the first: in the mean, and of the nearest 99 in 100 numbers. */
function apart(a: ArrayLike<number>, b: ArrayLike<number>) {
  const level = Array.from(a).reduce((sum, x) => sum + x, 0) / a.length;
  const far = Array.from(a, (x, i) => Math.abs(x - b[i]) / level).sort((x, y) => x - y);
  return { mean: far.reduce((sum, x) => sum + x, 0) / far.length, most: far[Math.floor(0.99 * far.length)] };
}

test('no shader reads more textures than every device has, and both kinds of devices draw alike what asks for all', async () => {
  const headless = await openPictures(SIZE, SIZE);
  const counts = countTextures(headless.gpu.device);
  expect(headless.gpu.device.limits.maxSampledTexturesPerShaderStage).toBe(EVERY_DEVICE);
  pumpFrame();
  const light = await fullPicture(headless.renderer);
  await headless.close();
  const mostOf = (kind: string) => Math.max(...[...counts].map(([name, count]) => (name.startsWith(kind) ? count : 0)));
  expect([mostOf('light'), mostOf('transparent')]).toEqual([MOST, MOST]);
  expect(Math.max(...counts.values())).toBe(MOST);

  const chromium = await openModulePage(fileURLToPath(new URL('./textureUnitsPage.ts', import.meta.url)));
  const inPage = await chromium.page.evaluate(() => window.takeFull());
  chromium.assertHealthy();
  await chromium.close();
  expect(inPage.textures).toBe(MOST);
  expect(Math.max(...light)).toBeGreaterThan(0.5);
  const { mean, most } = apart(light, inPage.light);
  expect(mean).toBeLessThan(0.02);
  expect(most).toBeLessThan(0.1);
});
