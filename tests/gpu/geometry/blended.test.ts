import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { openPictures } from '../support/openPictures.ts';
import { renderForms, SIZE } from './blendedScenes.ts';

/** What each of these may be apart where both show a surface: f32 in another order; normals are stored in 2 × 12 bits. */
const APART = [2e-5, 1e-5, 4e-3, 2e-2];

/** Skins look the same whether the GPU bends them by their joints, or gets the points of all vertices as the processor computes them. */
function checks(paint: () => Promise<number[][][][]>): void {
  it('joints and points give the same pictures', async () => {
    const [joints, points] = await paint();
    joints.forEach((view, i) => {
      const [isShown, isThere] = [view[1], points[i][1]].map((times) => times.map((t) => t !== 0));
      const shown = isShown.filter(Boolean).length;
      expect(shown).toBeGreaterThan(0.05 * SIZE * SIZE);
      // A pixel on an outline may be on either side of it.
      expect(isShown.filter((own, k) => own !== isThere[k]).length).toBeLessThan(4);
      view.forEach((values, part) => {
        const width = values.length / SIZE ** 2;
        const far = values.filter((x, k) => {
          const pixel = Math.floor(k / width);
          return isShown[pixel] && isThere[pixel] && Math.abs(x - points[i][part][k]) > APART[part] * (1 + Math.abs(x));
        });
        // Where one part of a body is in front of another, too.
        expect(far.length / width, `view ${i}, part ${part}`).toBeLessThan(0.01 * shown);
      });
    });
  });
}

describe('skins: WebGPU (Dawn)', () => {
  checks(async () => {
    const headless = await openPictures(SIZE, SIZE);
    const seen = await renderForms(headless.renderer);
    await headless.close();
    return seen;
  });
});

describe('skins: WebGL2 (Chromium)', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./blendedPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());

  checks(async () => {
    const seen = await chromium.page.evaluate(() => window.paintSkins());
    chromium.assertHealthy();
    return seen;
  });
});
