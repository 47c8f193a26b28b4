import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { toHalf } from '../../../src/math/half.ts';
import { fromAxisAngle, IDENTITY, rotate } from '../../../src/math/quat.ts';
import { dot, normalize, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { pixelSequence } from '../../../src/reference/sampling/pixelSequence.ts';
import { radiance } from '../../../src/reference/transport/path.ts';
import { directionFromLatLong, domeAxes, latLongFromDirection } from '../../../src/scene/lights/latLong.ts';
import { sampleTexture } from '../../../src/scene/materials/sampleTexture.ts';
import { sphere } from '../../../src/scene/mesh/primitives.ts';
import type { DomeLight, Material, Motion } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { dome, GREY, lambert, lit, mirror } from '../../support/lightKit.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = 40;
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

const SETTINGS: RenderSettings = { ...GREY, grid: false };
const VIEW: ViewPoint = { t: 0, position: [0, 0, 3], u: ZERO, orientation: IDENTITY, lens: perspective(0.9) };

const [W, H] = [256, 128];
const BRIGHT = normalize([0.8, 0.6, 0.5]);

/** The dome is rotated against the world. */
const TURN = fromAxisAngle(normalize([0.3, 1, -0.4]), 2.1);

/** Dim above, dimmer below, and a spot 40 times as bright, ten degrees wide, to the upper right. */
const DOME: DomeLight = {
  kind: 'dome',
  path: '/dome',
  color: [1, 1, 1],
  orientation: TURN,
  texture: {
    name: 'dome',
    width: W,
    height: H,
    data: Uint16Array.from({ length: 4 * W * H }, (_, i) => {
      if (i % 4 === 3) return toHalf(1);
      const [x, y] = [(i >> 2) % W, Math.floor((i >> 2) / W)];
      const n = rotate(TURN, directionFromLatLong((x + 0.5) / W, 1 - (y + 0.5) / H));
      return toHalf(dot(n, BRIGHT) > Math.cos(0.17) ? 40 : 0.6 + 0.4 * n[1]);
    }),
    colorSpace: 'linear',
    filter: 'linear',
    wrapS: 'repeat',
    wrapT: 'clamp',
  },
};

/** Mean difference of the rasterizer's ball from the reference's, relative to its brightest pixel. */
async function difference(material: Material, motion?: Motion, view = VIEW, sky = DOME): Promise<number> {
  const { scene } = lit([{ mesh: sphere(1, { segments: 96 }), material, ...(motion && { motion }) }], [sky]);
  await headless.renderer.setScene(scene);
  pumpFrame();
  headless.renderer.render([view], SETTINGS, 1);
  const drawn = await headless.renderer.readAov('beauty');
  const traced = lit([{ mesh: sphere(1, { segments: 96 }), material, ...(motion && { motion }) }], [sky]);
  const far: number[] = [];
  let brightest = 0;
  for (let y = 6; y < SIZE - 6; y += 3)
    for (let x = 6; x < SIZE - 6; x += 3) {
      const ray = cameraRay(view, SETTINGS, x + 0.5, y + 0.5, SIZE, SIZE)!;
      const numbers = pixelSequence(1, x, y);
      const options = { bounces: 1, mirrors: true, glass: false };
      let sum = 0;
      for (let i = 0; i < 400; i++) sum += radiance(traced, ray, view, SETTINGS, options, numbers(i))[1];
      brightest = Math.max(brightest, sum / 400);
      far.push(Math.abs(drawn[3 * (y * SIZE + x) + 1] - sum / 400));
    }
  return far.reduce((a, b) => a + b) / far.length / brightest;
}

it.each([
  ['matt', lambert(0.8), 0.03],
  ['a rough mirror', mirror({ roughness: 0.5 }), 0.06],
  ['a mirror that is a little rough', mirror({ roughness: 0.2 }), 0.02],
  ['a mirror', mirror({ roughness: 0.05 }), 0.01],
] as const)('a ball under a dome texture is lit as in the reference: %s', async (_, material, bound) => {
  expect(await difference(material)).toBeLessThan(bound);
});

it('on a moving ball light is aberrated and shifted', async () => {
  const motion: Motion = {
    kind: 'uniform',
    pose: { position: [1.2, 0, 0], orientation: IDENTITY },
    velocity: [0.6, 0, 0],
  };
  expect(await difference(lambert(0.8), motion)).toBeLessThan(0.02);
});

/** The greatest differences of a ball's pixels from the sky behind, relative to the sky. */
async function standsOut(material: Material, u: Vec3): Promise<number> {
  const sky: Vec3 = [0.5, 0.75, 0.25];
  await headless.renderer.setScene(lit([{ mesh: sphere(1, { segments: 24 }), material }], [dome(sky)]).scene);
  pumpFrame();
  headless.renderer.render([{ ...VIEW, u }], { ...SETTINGS, beaming: 0, occlusionRadius: 0 }, 1);
  const drawn = await headless.renderer.readAov('beauty');
  return drawn.reduce((most, value, i) => Math.max(most, Math.abs(value / sky[i % 3] - 1)), 0);
}

it.each([
  ['matt', lambert(1), 2e-3],
  ['a mirror', mirror(), 0.01],
  ['a rough metal', mirror({ roughness: 0.2 }), 0.01],
  ['a rougher metal', mirror({ roughness: 0.5 }), 0.01],
  ['the roughest metal', mirror({ roughness: 1 }), 0.01],
] as const)('a lossless reflector is invisible under a uniform dome: %s', async (_, material, bound) => {
  expect(await standsOut(material, ZERO)).toBeLessThan(bound);
  expect(await standsOut(material, properVelocity([0, 0, -0.5]))).toBeLessThan(bound);
});

const EVENING: DomeLight = {
  ...dome([0.1, 0.2, 0.6]),
  gradient: { horizon: [1.2, 0.7, 0.4], ground: [0.2, 0.15, 0.1] },
};

it('a matt ball under a sky with a horizon is lit as in the reference', async () => {
  expect(await difference(lambert(0.8), undefined, VIEW, EVENING)).toBeLessThan(0.01);
});

it('the sky shows the dome’s texture, rotated', async () => {
  await headless.renderer.setScene(lit([], [DOME]).scene);
  pumpFrame();
  const wide = { ...VIEW, lens: perspective(2) };
  headless.renderer.render([wide], SETTINGS, 1);
  const drawn = await headless.renderer.readAov('beauty');
  for (const [x, y] of [
    [3, 4],
    [30, 2],
    [20, 20],
    [8, 33],
  ]) {
    const n = normalize(cameraRay(wide, SETTINGS, x + 0.5, y + 0.5, SIZE, SIZE)!.dx);
    const expected = dot(n, BRIGHT) > Math.cos(0.17) ? 40 : 0.6 + 0.4 * n[1];
    expect(Math.abs(drawn[3 * (y * SIZE + x) + 1] - expected)).toBeLessThan(0.01 * expected);
  }
});

it('at speed a pixel shows the mean of the dome over what it covers, where it is many texels', async () => {
  // Grains of one texel; ahead, a pixel covers up to four by four.
  let seed = 1;
  const data = Uint16Array.from({ length: 4 * W * H }, (_, i) => {
    if (i % 4 === 0) seed = (seed * 16807) % 2147483647;
    return toHalf(i % 4 === 3 ? 1 : 0.5 + seed / 2147483647);
  });
  const sky = { ...DOME, texture: { ...DOME.texture!, data } };
  const view = { ...VIEW, u: properVelocity([0, 0, -0.9]) };
  const settings = { ...SETTINGS, beaming: 0 };
  await headless.renderer.setScene(lit([], [sky]).scene);
  pumpFrame();
  headless.renderer.render([view], settings, 1);
  const drawn = await headless.renderer.readAov('beauty');
  const [right, up, front] = domeAxes(sky);
  const radianceAt = (x: number, y: number): number => {
    const n = normalize(cameraRay(view, settings, x, y, SIZE, SIZE)!.dx);
    return sampleTexture(sky.texture, ...latLongFromDirection([dot(n, right), dot(n, up), dot(n, front)]))[0];
  };
  let [error, errorOfPoints] = [0, 0];
  for (let y = 1; y < SIZE; y += 3)
    for (let x = 1; x < SIZE; x += 3) {
      let mean = 0;
      for (let k = 0; k < 64; k++) mean += radianceAt(x + ((k % 8) + 0.5) / 8, y + (Math.floor(k / 8) + 0.5) / 8) / 64;
      error += Math.abs(drawn[3 * (y * SIZE + x)] - mean);
      errorOfPoints += Math.abs(radianceAt(x + 0.5, y + 0.5) - mean);
    }
  expect(error).toBeLessThan(0.4 * errorOfPoints);
});

it('a moving observer sees the ball as in the reference', async () => {
  expect(await difference(lambert(0.8), undefined, { ...VIEW, u: properVelocity([0, 0, -0.5]) })).toBeLessThan(0.03);
});
