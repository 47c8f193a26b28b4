import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { composeViews, type PixelRect, viewPixelAt } from '../../../src/scene/view/pictureViews.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import {
  accumulateTogetherAndAlone,
  CASES,
  CROP,
  EYES,
  LIGHT,
  pickBoth,
  type RenderedViews,
  renderTogetherAndAlone,
  renderWholeAndCrop,
  SCENE,
  SIZE,
} from './viewsScenes.ts';

const pixelsOf = ({ width, height }: PixelRect): number => width * height;
const BLACK = Float32Array.from({ length: 4 * SIZE.width * SIZE.height }, (_, i) => (i % 4 === 3 ? 255 : 0));

/** What the picture of both must be, put together of those alone by the test. */
function composed(parts: readonly (readonly number[])[], channels: number): number[] {
  const into = channels === 4 ? BLACK.slice() : new Float32Array(channels * SIZE.width * SIZE.height);
  const placed = parts.map((values, i) => ({ rect: EYES[i].viewport, values: Float32Array.from(values) }));
  return Array.from(composeViews(placed, SIZE, channels, into));
}

function expectSame(together: RenderedViews, alone: readonly RenderedViews[]): void {
  for (const [i, part] of alone.entries()) {
    expect(part.pixels.length).toBe(4 * pixelsOf(EYES[i].viewport));
    // Something is seen, and not everywhere the same.
    expect(new Set(part.depth).size).toBeGreaterThan(pixelsOf(EYES[i].viewport) / 4);
  }
  const of = (name: keyof RenderedViews) => alone.map((part) => part[name]);
  expect(together.depth).toEqual(composed(of('depth'), 1));
  expect(together.beauty).toEqual(composed(of('beauty'), 3));
  expect(together.pixels).toEqual(composed(of('pixels'), 4));
}

/** Each picked pixel has the values of the whole channels there, which are 32 bits wide. */
function expectPicked({ picked, channels }: Awaited<ReturnType<typeof pickBoth>>): void {
  for (const [i, found] of picked.entries()) {
    const { object, emission_time: time, position, velocity, doppler, depth, beauty } = channels[i];
    expect(found?.light).toEqual(beauty);
    expect(found?.surface?.objectId ?? 0).toBe(object[0]);
    if (!found?.surface) continue;
    const { surface } = found;
    expect(surface.path).toBe(SCENE.objects[object[0] - 1].path);
    const values = [[surface.emissionTime], surface.position, surface.velocity, [surface.doppler], [surface.depth]];
    expect(values.flat().map(Math.fround)).toEqual([time, position, velocity, doppler, depth].flat());
  }
  const paths = picked.map((found) => found?.surface?.path);
  for (const path of ['/Floor', '/Crate', '/Ball', undefined]) expect(paths).toContain(path);
}

describe('two views in one picture are, to the bit, the pictures of each', () => {
  let headless: HeadlessPictures;
  beforeAll(async () => {
    headless = await openPictures(SIZE.width, SIZE.height);
    await headless.renderer.setScene(SCENE);
  });
  afterAll(() => headless?.close());

  it.each(Object.keys(CASES))('%s, on WebGPU (Dawn)', async (name) => {
    const { together, alone } = await renderTogetherAndAlone(headless.renderer, name, pumpFrame);
    expectSame(together, alone);
  });

  it('also when a picture at rest gains samples', async () => {
    const { together, alone } = await accumulateTogetherAndAlone(headless.renderer, 2, pumpFrame);
    expect(together).toEqual(composed(alone, 4));
  });

  it('each pixel is picked, and metered, from its own view', async () => {
    const { renderer } = headless;
    renderer.setSize(SIZE.width, SIZE.height);
    pumpFrame();
    renderer.render(EYES, LIGHT, 1);
    const [object, depth] = [await renderer.readAov('object'), await renderer.readAov('depth')];
    for (const [x, y] of [
      [20, 25],
      [80, 30],
    ]) {
      const i = y * SIZE.width + x;
      expect(object[i]).toBeGreaterThan(0);
      expect((await renderer.pick(x, y))?.surface).toMatchObject({ objectId: object[i], depth: depth[i] });
    }
    expect(await renderer.pick(0, 0)).toBeUndefined();
    const { luminance } = await renderer.measureLight();
    expect(luminance[0]).toBeNaN();
    expect(Array.from(luminance).filter((value) => value > 0).length).toBeGreaterThan(1000);
  });

  it.each([1, 2])(
    'a picked pixel has the values of the channels, of a picture with n × n samples, n = %s',
    async (n) => {
      expectPicked(await pickBoth(headless.renderer, n, pumpFrame));
    },
  );

  it('a lens off the axis shows the same part of a larger picture', async () => {
    const { whole, crop } = await renderWholeAndCrop(headless.renderer, pumpFrame);
    let [same, apart, count] = [0, 0, 0];
    for (let y = 1; y < CROP.height - 1; y++)
      for (let x = 1; x < CROP.width - 1; x++) {
        const [i, k] = [y * CROP.width + x, (y + CROP.y) * SIZE.width + x + CROP.x];
        count++;
        if (crop.object[i] !== whole.object[k]) continue;
        same++;
        if (Math.abs(crop.doppler[i] - whole.doppler[k]) > 1e-4 * whole.doppler[k]) apart++;
      }
    expect(same / count).toBeGreaterThan(0.995);
    expect(apart / count).toBeLessThan(0.005);
    const found = viewPixelAt(EYES, SIZE, 60.5, 10.5);
    expect(found).toMatchObject({ index: 1, x: 3.5, y: 6.5 });
  });

  it('a picture of one view is left alone while one of two is compiled', async () => {
    const { renderer } = headless;
    const { viewport: _, ...whole } = EYES[0];
    const settings = { ...LIGHT, tone: 'agx' } as const;
    renderer.setSize(SIZE.width, SIZE.height);
    pumpFrame();
    renderer.render([whole], LIGHT, 1);
    const before = await renderer.readPixels();
    const coming = renderer.precompile(EYES, settings, 1);
    expect(coming).toBeDefined();
    pumpFrame();
    renderer.render([whole], LIGHT, 1);
    expect(await renderer.readPixels()).toEqual(before);
    expect((await renderer.measureLight()).luminance.some(Number.isNaN)).toBe(false);
    await coming;
    expect(renderer.precompile(EYES, settings, 1)).toBeUndefined();
    expect(await renderer.readPixels()).toEqual(before);
  });

  it('views that overlap are refused, and the last picture stays', async () => {
    const { renderer } = headless;
    renderer.setSize(SIZE.width, SIZE.height);
    pumpFrame();
    renderer.render(EYES, LIGHT, 1);
    const before = await renderer.readPixels();
    const [left] = EYES;
    expect(() => renderer.render([left, { ...EYES[1], viewport: left.viewport }], LIGHT, 1)).toThrow('view 2 (2, 1');
    expect(await renderer.readPixels()).toEqual(before);
  });
});

describe('on WebGL2', () => {
  let browser: ModulePage;
  beforeAll(async () => {
    browser = await openModulePage(fileURLToPath(new URL('./viewsPage.ts', import.meta.url)));
  });
  afterAll(() => browser?.close());

  it('two views are the pictures of each, and the canvas shows what is read back', async () => {
    const { together, alone } = await browser.page.evaluate(() => window.drawViews('with FXAA'));
    expectSame(together, alone);
    const { shown, read } = await browser.page.evaluate(() => window.presentViews());
    expect(shown).toEqual(read);
    browser.assertHealthy();
  });

  it.each([1, 2])('a picked pixel has the values of the channels, n = %s', async (n) => {
    expectPicked(await browser.page.evaluate((samples) => window.pickViews(samples), n));
    browser.assertHealthy();
  });
});
