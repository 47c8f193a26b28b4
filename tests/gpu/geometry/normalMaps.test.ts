import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { cross, dot, length, type Vec3 } from '../../../src/math/vec3.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { visibleHit } from '../../../src/reference/camera/visibleHit.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { surfaceAt } from '../../../src/reference/materials/surface.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { NORMAL_SCENES, type NormalScene, renderNormals, SIZE } from './normalMapsScenes.ts';

/** Sorted angles between normals of the rasterizer and of the reference [rad], where both hit a surface. */
function angles({ scene, view, settings }: NormalScene, normals: ArrayLike<number>): number[] {
  const traced = createTracedScene(scene, settings.speedOfLight);
  const found: number[] = [];
  for (let y = 3; y < SIZE; y += 5)
    for (let x = 3; x < SIZE; x += 5) {
      const at = 3 * (y * SIZE + x);
      const drawn: Vec3 = [normals[at], normals[at + 1], normals[at + 2]];
      const hit = visibleHit(traced, cameraRay(view, settings, x + 0.5, y + 0.5, SIZE, SIZE)!);
      if (!hit || length(drawn) === 0) continue;
      const { normal } = surfaceAt(traced, hit);
      found.push(Math.atan2(length(cross(drawn, normal)), dot(drawn, normal)));
    }
  return found.sort((a, b) => a - b);
}

/** For 98 % of the pixels, because of seams, and distant or slanted surfaces where mipmaps matter. */
const MAX_ERROR = 0.025;

/** Without anisotropic filtering SwiftShader interpolates texels of 8 bits in 8 bits: half a step of 1/127.5 is 4 mrad. */
const SWIFTSHADER_ROUNDING = 0.5 / 127.5;

function expectSame(scene: NormalScene, normals: ArrayLike<number>, rounding = 0): void {
  const found = angles(scene, normals);
  expect(found.length).toBeGreaterThan(60);
  const [half, most] = [0.5, 0.98].map((share) => found[Math.floor(share * found.length)]);
  if (process.env.REPORT) console.log(`${scene.name}: ${half.toExponential(1)} ${most.toExponential(1)}`);
  expect(half).toBeLessThan(Math.max(scene.tolerance, rounding));
  expect(most).toBeLessThan(MAX_ERROR);
}

describe('normal maps agree with the reference, on WebGPU', () => {
  let headless: HeadlessPictures;
  beforeAll(async () => {
    headless = await openPictures(SIZE, SIZE);
  });
  afterAll(() => headless?.close());
  it.each(NORMAL_SCENES)('$name', async (scene) => {
    pumpFrame();
    expectSame(scene, await renderNormals(headless.renderer, scene));
  });
});

describe('on WebGL2', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./normalMapsPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());
  it.each(NORMAL_SCENES)('$name', async (scene) => {
    const normals = await chromium.page.evaluate((name) => window.takeNormals(name), scene.name);
    chromium.assertHealthy();
    expectSame(scene, normals, SWIFTSHADER_ROUNDING);
  });
});
