import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { conjugate, rotate } from '../../../src/math/quat.ts';
import { length, normalize, scale, sub, type Vec3 } from '../../../src/math/vec3.ts';
import { apparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { visibleHit } from '../../../src/reference/camera/visibleHit.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { lensPixel } from '../../../src/scene/view/lenses/lenses.ts';
import { relativeLuminance } from '../../../src/scene/view/metering.ts';
import type { ViewPoint } from '../../../src/scene/view/view.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { C, eye, SETTINGS, thingsAround } from './thingsAround.ts';

const SCENE = thingsAround([
  ['/Right', [4, 1, 1], 1],
  ['/Left', [-3, 0, -1], 1],
  ['/Above', [0.5, 4, -0.5], 1],
]);
/** Wide apart, so that the eyes see differently. */
const SEPARATION = 0.4;
const VIEW = eye({ kind: 'stereo', separation: SEPARATION });
const SIDE = 384;
const SIZE = { width: SIDE, height: SIDE };

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIDE, SIDE);
  await headless.renderer.setScene(SCENE);
});
afterAll(() => headless?.close());

async function picture(view: ViewPoint, settings = SETTINGS) {
  const { renderer } = headless;
  pumpFrame();
  renderer.render([view], settings, 1);
  return {
    object: await renderer.readAov('object'),
    position: await renderer.readAov('position'),
    depth: await renderer.readAov('depth'),
    beauty: await renderer.readAov('beauty'),
  };
}

it('shows each eye what the reference finds along its curves, where the closed form puts it', async () => {
  const { object, position, depth } = await picture(VIEW);
  const traced = createTracedScene(SCENE, C);
  const seen = new Set<number>();
  let [all, same, farthest, otherDepth] = [0, 0, 0, 0];
  // Every third pixel: rays take their time.
  for (let i = 0; i < SIDE * SIDE; i += 3) {
    const [x, y] = [(i % SIDE) + 0.5, Math.floor(i / SIDE) + 0.5];
    const hit = visibleHit(traced, cameraRay(VIEW, SETTINGS, x, y, SIDE, SIDE)!);
    all++;
    if ((hit ? hit.object + 1 : 0) !== object[i]) continue;
    same++;
    if (!hit) continue;
    seen.add(hit.object);
    // In the space of what is seen, from where this eye is when one looks this way.
    const longitude = Math.PI * ((2 * x) / SIDE - 1);
    const aside = y < SIDE / 2 ? -SEPARATION / 2 : SEPARATION / 2;
    const eye: Vec3 = scale([Math.cos(longitude), 0, Math.sin(longitude)], aside);
    const event = Array.from(position.subarray(3 * i, 3 * i + 3)) as unknown as Vec3;
    const shown = sub(rotate(conjugate(VIEW.orientation), apparentPosition(sub(event, VIEW.position), VIEW.u)), eye);
    if (Math.abs(depth[i]! / length(shown) - 1) > 0.05) otherDepth++;
    const [px, above] = lensPixel(VIEW.lens, normalize(shown), SIZE)!;
    const py = y < SIDE / 2 ? above : above + SIDE / 2;
    const across = Math.min(Math.abs(px - x), SIDE - Math.abs(px - x));
    // Towards the poles directions are stretched.
    if (Math.hypot(normalize(shown)[0], normalize(shown)[2]) > 0.7)
      farthest = Math.max(farthest, Math.hypot(across, py - y));
  }
  expect(seen.size).toBe(SCENE.objects.length);
  expect(same / all).toBeGreaterThan(0.99);
  // Eyes stand still over a strip of 48 columns: the edges of one are 1.3 pixels off in 2 m, and eyes 6 pixels apart.
  expect(farthest).toBeLessThan(2.5);
  expect(otherDepth / all).toBeLessThan(0.002);
});

it('has no seams: between strips, light changes from pixel to pixel as it does inside them', async () => {
  const { beauty } = await picture({ ...VIEW, lens: { kind: 'stereo', separation: 0.063 } });
  const luminance = (x: number, y: number): number => {
    const i = 3 * (y * SIDE + x);
    return relativeLuminance(beauty[i]!, beauty[i + 1]!, beauty[i + 2]!);
  };
  const [across, inside]: [number[], number[]] = [[], []];
  for (let y = 0; y < SIDE; y++)
    for (let x = 1; x < SIDE; x++) {
      const [a, b] = [luminance(x - 1, y), luminance(x, y)];
      (x % 48 === 0 ? across : inside).push(Math.abs(a - b) / ((a + b) / 2 + 1e-6));
    }
  const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;
  expect(mean(across)).toBeLessThan(1.1 * mean(inside));
});

it('is two equal pictures where the eyes are together, those of the equirectangular lens', async () => {
  const { object, beauty } = await picture({ ...VIEW, lens: { kind: 'stereo', separation: 1e-9 } });
  const half = object.length / 2;
  expect(object.subarray(0, half).filter((id, i) => id !== object[half + i]).length).toBe(0);
  expect(beauty.subarray(0, 3 * half)).toEqual(beauty.subarray(3 * half));
  const { renderer } = headless;
  renderer.setSize(SIDE, SIDE / 2);
  const flat = await picture({ ...VIEW, lens: { kind: 'equirectangular' } });
  renderer.setSize(SIDE, SIDE);
  expect(flat.object.filter((id, i) => id !== object[i]).length / half).toBeLessThan(0.01);
  // Texels of other faces are up to a pixel away, where light may change.
  const apart = Array.from(flat.beauty, (value, i) => Math.abs(beauty[i]! / value - 1)).sort((a, b) => a - b);
  expect(apart[Math.floor(apart.length / 2)]).toBeLessThan(0.02);
  expect(apart[Math.floor(0.95 * apart.length)]).toBeLessThan(0.15);
});
