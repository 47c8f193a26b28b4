import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { openModulePage } from '../support/modulePage.ts';
import { openPictures } from '../support/openPictures.ts';
import { fullPicture, SIZE } from './textureUnitsScene.ts';

/** Textures per fragment shader guaranteed by WebGPU and WebGL2. */
const EVERY_DEVICE = 16;
/** Textures used by the largest shaders: a new table belongs in the atlas or the scene's float table, not in its own texture. */
const MAX_TEXTURES = 13;

/** Number of textures read by each kind of fragment shader, recorded when pipelines are created. */
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

/** Difference of two pictures relative to the mean of the first: mean and 99th percentile. */
function apart(a: ArrayLike<number>, b: ArrayLike<number>) {
  const level = Array.from(a).reduce((sum, x) => sum + x, 0) / a.length;
  const far = Array.from(a, (x, i) => Math.abs(x - b[i]) / level).sort((x, y) => x - y);
  return { mean: far.reduce((sum, x) => sum + x, 0) / far.length, most: far[Math.floor(0.99 * far.length)] };
}

test('no shader reads more textures than every device has, and both backends draw a scene with all features alike', async () => {
  const headless = await openPictures(SIZE, SIZE);
  const counts = countTextures(headless.gpu.device);
  expect(headless.gpu.device.limits.maxSampledTexturesPerShaderStage).toBe(EVERY_DEVICE);
  pumpFrame();
  const light = await fullPicture(headless.renderer);
  await headless.close();
  const mostOf = (kind: string) => Math.max(...[...counts].map(([name, count]) => (name.startsWith(kind) ? count : 0)));
  expect([mostOf('light'), mostOf('transparent')]).toEqual([MAX_TEXTURES, MAX_TEXTURES]);
  expect(Math.max(...counts.values())).toBe(MAX_TEXTURES);

  const chromium = await openModulePage(fileURLToPath(new URL('./textureUnitsPage.ts', import.meta.url)));
  const inPage = await chromium.page.evaluate(() => window.takeFull());
  chromium.assertHealthy();
  await chromium.close();
  expect(inPage.textures).toBe(MAX_TEXTURES);
  expect(Math.max(...light)).toBeGreaterThan(0.5);
  const { mean, most } = apart(light, inPage.light);
  expect(mean).toBeLessThan(0.02);
  expect(most).toBeLessThan(0.1);
});
