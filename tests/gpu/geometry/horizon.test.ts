import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { DEFAULT_LIGHT } from '../../../src/reference/lights/lightOptions.ts';
import { renderTile } from '../../../src/reference/tile.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { CASES, drawHorizon, type HorizonCase, SETTINGS, SIZE, sceneOf, viewOf } from './horizonScenes.ts';

const { width, height } = SIZE;

/** No pixel shows the body but those of the reference and their neighbours, and D is that of the reference. */
function expectAsReference(drawn: Awaited<ReturnType<typeof drawHorizon>>, horizonCase: HorizonCase): void {
  const traced = renderTile(
    createTracedScene(sceneOf(horizonCase), SETTINGS.speedOfLight),
    {
      view: viewOf(horizonCase),
      settings: SETTINGS,
      width,
      height,
      layers: ['object', 'doppler'],
      samples: 1,
      seed: 1,
      light: DEFAULT_LIGHT,
    },
    { x0: 0, y0: 0, x1: width, y1: height },
  );
  const [object, doppler] = [traced.object!, traced.doppler!];
  const near = (i: number): number[] =>
    [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => i + dy * width + dx)).filter((k) => object[k] !== undefined);
  const seen = drawn.object.flatMap((id, i) => (id > 0.5 ? [i] : []));
  expect(seen.filter((i) => near(i).every((k) => object[k] === 0))).toEqual([]);
  const inside = Array.from(object.keys()).filter((i) => object[i] && near(i).every((k) => object[k]));
  expect(inside.filter((i) => drawn.object[i] < 0.5)).toEqual([]);
  expect(inside.filter((i) => !(Math.abs(drawn.doppler[i] / doppler[i] - 1) < 0.05))).toEqual([]);
  expect(seen.length).toBeGreaterThanOrEqual(horizonCase.atLeast);
  expect(drawn.doppler.every(Number.isFinite)).toBe(true);
}

describe('a body that straddles its horizon is drawn as by the reference', () => {
  describe('on WebGPU (Dawn)', () => {
    let headless: HeadlessPictures;
    beforeAll(async () => {
      headless = await openPictures(width, height);
    });
    afterAll(() => headless?.close());

    it.each(CASES)('$name', async (horizonCase) => {
      expectAsReference(await drawHorizon(headless.renderer, horizonCase.name, pumpFrame), horizonCase);
    });
  });

  describe('on WebGL2 (Chromium)', () => {
    let chromium: ModulePage;
    beforeAll(async () => {
      chromium = await openModulePage(fileURLToPath(new URL('./horizonPage.ts', import.meta.url)));
    });
    afterAll(() => chromium?.close());

    it.each(CASES)('$name', async (horizonCase) => {
      expectAsReference(
        await chromium.page.evaluate((name) => window.drawHorizon(name), horizonCase.name),
        horizonCase,
      );
      chromium.assertHealthy();
    });
  });
});
