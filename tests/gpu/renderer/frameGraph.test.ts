import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { aovsOfFrameGraph, evaluateFrameGraph } from '../../../src/reference/post/frameGraph.ts';
import type { AovName } from '../../../src/scene/view/view.ts';
import { openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import {
  FRAME_GRAPH,
  type RenderedFrameGraph,
  renderFrameGraph,
  renderStillImages,
  SCENES,
  SETTINGS,
  SHADOWS,
  SIZE,
  STILLS,
  showing,
  still,
  VIEW,
} from './frameGraphScenes.ts';

/** Tolerance relative to a value, after eight images; and for false colours, which the reference has in 8 bits. */
const [TOLERANCE, FLOOR] = [0.01, 0.5];

/** The reference's result for the same G-buffers. */
function expectAsReference({ light, buffers }: RenderedFrameGraph): void {
  const taken = buffers.map((data) => ({
    aovs: new Map(Object.entries(data).map(([name, values]) => [name as AovName, Float32Array.from(values)])),
    zenith: [0, 1, 0] as const,
  }));
  const truth = evaluateFrameGraph({ view: VIEW, settings: SETTINGS, ...SIZE, buffers: taken }).values;
  expect(light.length).toBe(truth.length);
  const errors = Array.from(truth, (value, i) => Math.abs(value - light[i]) / (Math.abs(value) + FLOOR));
  if (process.env.REPORT) console.log(Math.max(...errors), errors.filter((each) => each > TOLERANCE).length);
  expect(Math.max(...errors)).toBeLessThan(TOLERANCE);
  expect(new Set(truth).size).toBeGreaterThan(1000);
}

/** A still of the picture's size is reproduced to the bit; others as fitted by the reference. */
function expectStills(lights: readonly (readonly number[])[]): void {
  STILLS.forEach(([width, height], i) => {
    const made = still(width, height);
    const light = lights[i]!;
    if (i === 0) expect(light).toEqual(Array.from(made.pixels));
    const taken = { view: VIEW, settings: showing(made), ...SIZE, buffers: [] };
    const truth = evaluateFrameGraph(taken).values;
    expect(light.length).toBe(truth.length);
    const errors = Array.from(truth, (value, k) => Math.abs(value - light[k]!) / (value + 1e-3));
    if (process.env.REPORT) console.log(width, height, Math.max(...errors));
    expect(Math.max(...errors)).toBeLessThan(1e-4);
  });
}

describe('a frame graph is executed as by the reference', () => {
  let headless: HeadlessPictures;
  beforeAll(async () => {
    headless = await openPictures(SIZE.width, SIZE.height);
  });
  afterAll(() => headless?.close());

  it('on WebGPU (Dawn)', async () => {
    pumpFrame();
    expectAsReference(await renderFrameGraph(headless.renderer, aovsOfFrameGraph(FRAME_GRAPH)));
  });

  it('stills are placed in the picture as by the reference, each updated, on WebGPU (Dawn)', async () => {
    pumpFrame();
    expectStills(await renderStillImages(headless.renderer));
  });

  it('arguments change without new shaders, and changing them back restores the picture', async () => {
    const { renderer } = headless;
    const { frameGraph, ...plain } = SETTINGS;
    await renderer.setScene(SCENES[0], SCENES.slice(1));
    const drawn = async (settings: typeof SETTINGS): Promise<Uint8Array> => {
      pumpFrame();
      renderer.render([VIEW], settings);
      return renderer.readPixels();
    };
    const [bare, first] = [await drawn(plain), await drawn(SETTINGS)];
    const steps = FRAME_GRAPH.passes.map((step) => (step.kind === 'mix' ? { ...step, alpha: 0.25 } : step));
    expect(renderer.precompile([VIEW], { ...SETTINGS, frameGraph: { ...FRAME_GRAPH, passes: steps } })).toBeUndefined();
    expect(await drawn({ ...SETTINGS, frameGraph: { ...FRAME_GRAPH, passes: steps } })).not.toEqual(first);
    expect(await drawn(SETTINGS)).toEqual(first);
    expect(await drawn(plain)).toEqual(bare);
    expect(first).not.toEqual(bare);
    expect(frameGraph).toBe(FRAME_GRAPH);
  });

  it('one G-buffer can be lit with and without shadows', async () => {
    const { renderer } = headless;
    const { frameGraph: _, ...plain } = SHADOWS;
    const light = async (settings: typeof SHADOWS): Promise<Float32Array> => {
      pumpFrame();
      renderer.render([VIEW], settings);
      return renderer.readAov('beauty');
    };
    const [lit, bright] = [
      await light({ ...plain, occlusionRadius: 0 }),
      await light({ ...plain, occlusionRadius: 0, shadows: false }),
    ];
    const both = await light(SHADOWS);
    both.forEach((value, i) => {
      expect(Math.abs(value - Math.abs(lit[i] - bright[i]))).toBeLessThan(0.002);
    });
    expect(Math.max(...both)).toBeGreaterThan(0.1);
  });
});

it('a frame graph is executed on WebGL2 too', async () => {
  const chromium = await openModulePage(fileURLToPath(new URL('./frameGraphPage.ts', import.meta.url)));
  try {
    const drawn = await chromium.page.evaluate((needed) => window.drawPlan(needed), aovsOfFrameGraph(FRAME_GRAPH));
    chromium.assertHealthy();
    expectAsReference(drawn);
    expectStills(await chromium.page.evaluate(() => window.drawStills()));
    chromium.assertHealthy();
  } finally {
    await chromium.close();
  }
});
