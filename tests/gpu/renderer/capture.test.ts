import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { add, type Vec3 } from '../../../src/math/vec3.ts';
import { openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { agreement, CAPTURED, DIRECT, difference, type Picture, picture, SCENE, SIZE, VIEWS } from './captureScenes.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE.width, SIZE.height);
  await headless.renderer.setScene(SCENE);
});
afterAll(() => headless?.close());

function expectAgreement(name: string, found: Awaited<ReturnType<typeof agreement>>[number]): void {
  console.log(name, found);
  // Looking back at 0.9 c a texel covers up to 2 × 2 pixels.
  expect(found.same, name).toBeGreaterThan(name.includes('back') ? 0.99 : 0.995);
  expect(found.light, name).toBeLessThan(0.02);
  expect(found.doppler, name).toBeLessThan(0.02);
  expect(found.depth, name).toBeLessThan(0.005);
  expect(found.normal, name).toBeLessThan(0.01);
  expect(found.drawnTriangles).toBeGreaterThan(100);
  expect(found.capturedTriangles).toBe(0);
}

describe('a capture, drawn once, shows an observer of any velocity, direction and lens at its event what drawing anew shows him, without drawing any geometry', () => {
  it('on WebGPU', async () => {
    const found = await agreement(headless.renderer, Object.keys(VIEWS), pumpFrame);
    Object.keys(VIEWS).forEach((name, i) => {
      expectAgreement(name, found[i]!);
    });
  });

  it('on WebGL2', async () => {
    const { page, assertHealthy, close } = await openModulePage(
      fileURLToPath(new URL('./capturePage.ts', import.meta.url)),
    );
    const names = ['0.9 c ahead', '0.9 c, looking back', '0.6 c, dome'];
    try {
      const found = await page.evaluate((asked) => window.captureAgreement(asked), names);
      names.forEach((name, i) => {
        expectAgreement(name, found[i]!);
      });
      assertHealthy();
    } finally {
      await close();
    }
  });
});
