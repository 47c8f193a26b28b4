import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { PreviewRenderer } from '../../../src/render/previews.ts';
import type { FrameGraph } from '../../../src/scene/frameGraph/frameGraph.ts';
import type { RenderSettings } from '../../../src/scene/view/view.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { FRAME_GRAPH, SCENES, SETTINGS, SIZE, VIEW } from './frameGraphScenes.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE.width, SIZE.height);
});
afterAll(() => headless?.close());

const LAST = FRAME_GRAPH.passes.length - 1;
/** 8-bit sRGB, by the standard's formula. */
const encoded = (x: number): number => {
  const shown = Math.min(1, Math.max(0, x));
  return 255 * (shown <= 0.0031308 ? 12.92 * shown : 1.055 * shown ** (1 / 2.4) - 0.055);
};

it('a preview equals a picture of its size, and does not affect the displayed picture', async () => {
  const { renderer } = headless;
  const previews = new PreviewRenderer(renderer);
  const settings = { ...SETTINGS, antialiasing: true };
  await renderer.setScene(SCENES[0], SCENES.slice(1));
  const film = async (between: () => Promise<unknown>): Promise<readonly Uint8Array[]> => {
    const frames: Uint8Array[] = [];
    // A still picture first: it has nothing to do with those before.
    renderer.render([VIEW], settings);
    for (let i = 0; i < 3; i++) {
      pumpFrame();
      renderer.render([{ ...VIEW, t: VIEW.t + i / 30 }], settings, 'temporal');
      await between();
      frames.push(await renderer.readPixels());
    }
    return frames;
  };
  const still = async <Made>(shown: RenderSettings, between: () => Promise<Made>) => {
    renderer.render([VIEW], shown);
    const made = await between();
    let samples = 1;
    while (renderer.accumulate(2)) samples++;
    return { made, samples, pixels: await renderer.readPixels(), data: await renderer.readAov('emission_time') };
  };
  const half = { width: SIZE.width / 2, height: SIZE.height / 2 };
  const make = () =>
    previews.make(
      FRAME_GRAPH,
      [
        { kind: 'image', step: LAST },
        { kind: 'luminance', step: 0 },
        { kind: 'albedo', buffer: 0 },
      ],
      half,
    );
  const { frameGraph: _, ...bare } = settings;
  const plain: RenderSettings = { ...bare, grid: true };
  const light: FrameGraph = { extraBuffers: [], passes: FRAME_GRAPH.passes.slice(0, 1) };
  const nothing = () => Promise.resolve(undefined);

  // The sample positions of a sequence repeat after 16 pictures.
  const before = await film(nothing);
  for (let i = 3; i < 16; i++) renderer.render([VIEW], settings, 'temporal');
  expect(await film(make)).toEqual(before);
  const [undisturbed, disturbed] = [await still(settings, nothing), await still(settings, make)];
  expect({ ...disturbed, made: 0 }).toEqual({ ...undisturbed, made: 0 });

  const one = () => previews.make(light, [{ kind: 'image', step: 0, exposure: 1 }], half);
  const [alone, accompanied] = [await still(plain, nothing), await still(plain, one)];
  expect({ ...accompanied, made: 0 }).toEqual({ ...alone, made: 0 });

  const [image, lit, surfaces] = disturbed.made!;
  renderer.setSize(half.width, half.height);
  renderer.render([VIEW], { ...settings, antialiasing: false });
  const truth = await renderer.readAov('beauty');
  const albedo = await renderer.readAov('albedo');
  renderer.render([VIEW], { ...bare, antialiasing: false });
  const { luminance } = await renderer.measureLight();
  renderer.setSize(SIZE.width, SIZE.height);
  /** Fraction of channels more than two steps off the truth: small, because the tessellation is that of the larger picture. */
  const beside = (rgba: ArrayLike<number>, rgb: Float32Array): number =>
    rgb.filter((value, i) => Math.abs(rgba[4 * Math.floor(i / 3) + (i % 3)]! - encoded(value)) > 2).length / rgb.length;
  expect(beside(image!, truth)).toBeLessThan(0.01);
  expect(beside(surfaces!, albedo)).toBeLessThan(0.01);
  expect(new Set(truth).size).toBeGreaterThan(100);
  const apart = luminance.filter((value, i) => Math.abs(value - lit![i]!) > 0.01 * (1 + value));
  expect(apart.length).toBeLessThan(0.01 * luminance.length);
  previews.dispose();
});
