import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { addScaled, cross, length, normalize, scale, sub, type Vec3 } from '../../../src/math/vec3.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { pixelSequence } from '../../../src/reference/sampling/pixelSequence.ts';
import { radiance } from '../../../src/reference/transport/path.ts';
import { DIRECT } from '../../support/lightKit.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { LOCAL_LIGHT_SCENES, type LocalLightScene, renderLight, SIZE, sphereOver } from './localLightShadowsScenes.ts';

const STEP = 4;
/** Rays per pixel for area lights. */
const SAMPLES = 16;

/** The reference's light in every fourth pixel of every fourth row. */
function truthOf({ scene, view, settings }: LocalLightScene): { readonly at: number; readonly light: number }[] {
  const soft = scene.scene.lights.some((light) => light.kind !== 'dome' && !('radius' in light && light.radius === 0));
  const samples = soft ? SAMPLES : 1;
  const pixels: { at: number; light: number }[] = [];
  for (let y = 2; y < SIZE; y += STEP)
    for (let x = 2; x < SIZE; x += STEP) {
      const ray = cameraRay(view, settings, x + 0.5, y + 0.5, SIZE, SIZE)!;
      const numbers = pixelSequence(1, x, y);
      let light = 0;
      for (let i = 0; i < samples; i++) light += radiance(scene, ray, view, settings, DIRECT, numbers(i))[1] / samples;
      pixels.push({ at: y * SIZE + x, light });
    }
  return pixels;
}

/** Mean difference of a picture from the reference's, relative to its mean, and the fraction of pixels off by more than a quarter of its maximum. */
function apart(drawn: readonly number[], truth: ReturnType<typeof truthOf>) {
  const light = truth.map((pixel) => pixel.light);
  const far = truth.map(({ at, light }) => Math.abs(drawn[at] - light));
  const sum = (numbers: readonly number[]) => numbers.reduce((a, b) => a + b);
  const much = 0.25 * Math.max(...light);
  return { mean: sum(far) / sum(light), wrong: far.filter((off) => off > much).length / far.length };
}

function expectSame({ name }: LocalLightScene, drawn: readonly number[], truth: ReturnType<typeof truthOf>): number {
  const { mean, wrong } = apart(drawn, truth);
  if (process.env.REPORT) console.log(name, { mean, wrong });
  expect(mean).toBeLessThan(0.02);
  expect(wrong).toBeLessThan(0.007);
  return mean;
}

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

describe('shadows of local lights agree with the reference, on WebGPU', () => {
  it.each(LOCAL_LIGHT_SCENES)('$name', async (scene) => {
    pumpFrame();
    const truth = truthOf(scene);
    const mean = expectSame(scene, await renderLight(headless.renderer, scene), truth);
    const open = apart(await renderLight(headless.renderer, scene, false), truth);
    if (process.env.REPORT) console.log(scene.name, 'without', open.mean);
    expect(open.mean).toBeGreaterThan(4 * mean);
  });
});

/** Number of floor pixels, and of those where the picture differs from the closed form of the shadow, farther from its edge than a fraction of the ball's radius. */
async function againstForm(velocity: Vec3, margin: number, retarded: boolean) {
  const { scene, lamp, ball, radius } = sphereOver(velocity);
  pumpFrame();
  const light = await renderLight(headless.renderer, scene);
  const place = await headless.renderer.readAov('position');
  const counts = { floor: 0, shadow: 0, wrong: 0 };
  for (let i = 0; i < SIZE * SIZE; i++) {
    const p: Vec3 = [place[3 * i], place[3 * i + 1], place[3 * i + 2]];
    if (!(Math.abs(p[1]) < 1e-3)) continue;
    const passes = distanceFrom(p, lamp, ball, velocity, retarded ? scene.view.position : undefined);
    counts.floor++;
    if (passes < radius) counts.shadow++;
    if (Math.abs(passes - radius) > margin * radius && passes < radius !== light[i] < 1e-6) counts.wrong++;
  }
  return counts;
}

/**
 * Least distance of a light ray, from a light to a floor event that is seen at t = 0, from the centre of a ball at `ball` + v·t: in coordinates that
 * move with the ball the ray is straight along n − v. Without an observer everything is at the moment t = 0.
 */
function distanceFrom(p: Vec3, lamp: Vec3, ball: Vec3, v: Vec3, eye: Vec3 | undefined): number {
  const n = normalize(sub(p, lamp));
  const sent = eye ? -length(sub(p, eye)) - length(sub(p, lamp)) : 0;
  const from = sub(lamp, addScaled(ball, v, sent));
  const way = eye ? sub(n, v) : n;
  return length(cross(from, scale(way, 1 / length(way))));
}

describe('the shadow of a ball on a floor', () => {
  it('of a point light at rest is a conic: the points within the cone around the ball', async () => {
    const { floor, shadow, wrong } = await againstForm([0, 0, 0], 0.02, true);
    expect(floor).toBeGreaterThan(4000);
    expect(shadow).toBeGreaterThan(500);
    expect(wrong).toBe(0);
  });

  it('that moves is where the ball was when the light passed it', async () => {
    const { shadow, wrong } = await againstForm([0.6, 0, -0.2], 0.05, true);
    if (process.env.REPORT) console.log({ shadow, wrong });
    expect(shadow).toBeGreaterThan(500);
    expect(wrong).toBe(0);
    expect((await againstForm([0.6, 0, -0.2], 0.05, false)).wrong).toBeGreaterThan(500);
  });
});

describe('on WebGL2', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./localLightShadowsPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());
  it.each(LOCAL_LIGHT_SCENES.filter((_, i) => i % 4 === 0))('$name', async (scene) => {
    const drawn = await chromium.page.evaluate((name) => window.takeLight(name), scene.name);
    chromium.assertHealthy();
    expectSame(scene, drawn, truthOf(scene));
  });
});
