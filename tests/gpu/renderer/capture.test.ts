import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { addScaled, type Vec3 } from '../../../src/math/vec3.ts';
import { openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { agreement, CAPTURED, DIRECT, difference, LAYERED, picture, SCENE, SIZE, VIEWS } from './captureScenes.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE.width, SIZE.height);
  await headless.renderer.setScene(SCENE);
});
afterAll(() => headless?.close());

function expectAgreement(name: string, found: Awaited<ReturnType<typeof agreement>>[number]): void {
  expect(found.same, name).toBeGreaterThan(0.995);
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

describe('an observer who flies on', () => {
  const view = VIEWS['0.9 c ahead']!;
  const step: Vec3 = [0.9, 0, -4];
  /** After this many pictures of a slow flight: 0.1 mm and 0.1 ms each. */
  const later = (n: number) => ({
    ...view,
    t: view.t + 1e-4 * n,
    position: addScaled(view.position, step, 3e-5 * n),
  });

  it('sees far things at rest from the capture, near and moving ones drawn, and nothing farther than half a pixel beside its place', async () => {
    const { renderer } = headless;
    const other = renderer.beside();
    await other.setScene(SCENE);
    const drawnObjects: number[] = [];
    for (let n = 0; n <= 10; n++) {
      const drawn = await picture(renderer, later(n), DIRECT, pumpFrame);
      const captured = await picture(other, later(n), CAPTURED, pumpFrame);
      const found = difference(drawn, captured);
      expect(found.same, `picture ${n}`).toBeGreaterThan(0.99);
      expect(found.light, `picture ${n}`).toBeLessThan(0.02);
      if (n === 0) expect(captured.triangles).toBe(0);
      else expect(captured.triangles, `picture ${n}`).toBeGreaterThan(0);
      drawnObjects.push(other.info.objectsDrawn);
    }
    expect(drawnObjects.filter((count) => count > 0 && count < SCENE.objects.length - 2).length).toBeGreaterThan(6);
    // Where he stays, all is captured again.
    await picture(other, later(10), CAPTURED, pumpFrame);
    expect((await picture(other, later(10), CAPTURED, pumpFrame)).triangles).toBe(0);
    other.dispose();
  });
});

it('what a capture does not hold is drawn over it, at its depth: transparent things, layers and stars', async () => {
  const { renderer } = headless;
  const other = renderer.beside();
  for (const each of [renderer, other]) await each.setScene(LAYERED);
  const view = VIEWS['0.6 c aside']!;
  const drawn = await picture(renderer, view, DIRECT, pumpFrame);
  await picture(other, view, CAPTURED, pumpFrame);
  const captured = await picture(other, view, CAPTURED, pumpFrame);
  expect(new Set(drawn.object)).toContain(SCENE.objects.length + 2);
  const { same, light, light90 } = difference(drawn, captured);
  expect(same).toBeGreaterThan(0.995);
  expect(light).toBeLessThan(0.02);
  expect(light90).toBeLessThan(0.05);
  other.dispose();
  await renderer.setScene(SCENE);
});
