import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { renderSheets, SHEET_LIGHTS, type SheetShade } from './movingSheetsScenes.ts';

/** Nothing is between the light and a sheet: it has all the light that it has without shadows. */
function expectUnshaded(sheets: readonly SheetShade[]): void {
  for (const [name, pixels, shade] of sheets) {
    if (process.env.REPORT) console.log(name, pixels, shade.toFixed(4));
    expect(pixels, name).toBeGreaterThan(60);
    expect.soft(shade, name).toBeLessThan(0.01);
  }
}

describe('sheets that move do not shade themselves, on WebGPU', () => {
  let headless: HeadlessPictures;
  beforeAll(async () => {
    headless = await openPictures(16, 16);
  });
  afterAll(() => headless?.close());
  it.each(SHEET_LIGHTS)('under a $light at c = $speedOfLight', async (light) => {
    pumpFrame();
    expectUnshaded(await renderSheets(headless.renderer, light));
  });
});

describe('on WebGL2', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./movingSheetsPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());
  it.each(SHEET_LIGHTS)('under a $light at c = $speedOfLight', async (light) => {
    const sheets = await chromium.page.evaluate((chosen) => window.captureSheets(chosen), light);
    chromium.assertHealthy();
    expectUnshaded(sheets);
  });
});
