import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY } from '../../../src/math/quat.ts';
import { addScaled, scale, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { pixelSequence } from '../../../src/reference/sampling/pixelSequence.ts';
import { radiance } from '../../../src/reference/transport/path.ts';
import { makeMaterial } from '../../../src/scene/defaults.ts';
import { plane } from '../../../src/scene/mesh/primitives.ts';
import type { Light, Material, TextureChannel } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { blackbodyColor } from '../../../src/spectrum/color/blackbodyColor.ts';
import { dopplerTint } from '../../../src/spectrum/doppler/dopplerTint.ts';
import { DIRECT, dome, lamp, lit, picture } from '../../support/lightKit.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = 9;
/** The reference's samples, for directions and wavelengths. */
const SAMPLES = 2000;
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1 };

/** The middle pixel of a wall under a uniform dome, by the rasterizer and by the reference. */
async function colors(
  material: Partial<Material>,
  sky: Vec3,
  beta: number,
  settings = SETTINGS,
  lamps: readonly Light[] = [],
): Promise<readonly [Vec3, Vec3]> {
  const wall = { mesh: plane(40, 40), material: makeMaterial({ name: 'wall', ior: 1, roughness: 1, ...material }) };
  const scene = lit([wall], [dome(sky), ...lamps]);
  await headless.renderer.setScene(scene.scene);
  const view: ViewPoint = {
    t: 0,
    position: [0, 0, 5],
    u: properVelocity([0, 0, -beta]),
    orientation: IDENTITY,
    lens: perspective(0.1),
  };
  pumpFrame();
  headless.renderer.render([view], settings, 1);
  const drawn = await headless.renderer.readAov('beauty');
  const at = 3 * (4 * SIZE + 4);
  const ray = cameraRay(view, settings, 4.5, 4.5, SIZE, SIZE)!;
  const numbers = pixelSequence(1, 4, 4);
  let expected = ZERO;
  for (let i = 0; i < SAMPLES; i++)
    expected = addScaled(
      expected,
      radiance(scene, ray, view, settings, { ...DIRECT, bounces: 1 }, numbers(i)),
      1 / SAMPLES,
    );
  return [[drawn[at], drawn[at + 1], drawn[at + 2]], expected];
}

it.each([-0.6, 0, 0.6])('an emitter of 1,800 K looks like a blackbody of another temperature at %s c', async (beta) => {
  const [drawn, expected] = await colors(
    { baseColor: ZERO, emissive: [2, 2, 2], emissionTemperature: 1800 },
    ZERO,
    beta,
  );
  const most = Math.max(...expected);
  for (const k of [0, 1, 2]) expect(Math.abs(drawn[k] - expected[k]) / most).toBeLessThan(0.02);
  // Red at rest: little of its light is blue.
  if (beta === 0) expect(drawn[2]).toBeLessThan(0.2 * drawn[0]);
});

it.each([-0.2, 0, 0.6])('in approximate colours it has the colour of 1,800 K, tinted, at %s c', async (beta) => {
  const glow = { baseColor: ZERO, emissive: [2, 2, 2], emissionTemperature: 1800 } as const;
  const [drawn, expected] = await colors(glow, ZERO, beta, { ...SETTINGS, colors: 'approximate' });
  const most = Math.max(...expected);
  for (const k of [0, 1, 2]) expect(Math.abs(drawn[k] - expected[k]) / most).toBeLessThan(0.01);
  const ofT = scale(blackbodyColor(1800), 2);
  const D = Math.sqrt((1 + beta) / (1 - beta));
  // The wall is seen head-on, so the shift is only the observer's.
  dopplerTint(ofT, D, 1).forEach((value, k) => {
    expect(Math.abs(value * D ** 4 - drawn[k]) / most).toBeLessThan(0.06);
  });
});

it.each([
  ['infrared', 0.6, { ir: 0.9 }, { ir: 0 }],
  ['ultraviolet', -0.6, { uv: 0.9 }, { uv: 0 }],
] as const)('%s light becomes visible at %s c', async (_, beta, bright, dark) => {
  const material = { baseColor: [0.2, 0.3, 0.1] } as const;
  const [drawn, expected] = await colors({ ...material, ...bright }, [1, 1, 1], beta);
  const [dim, expectedDim] = await colors({ ...material, ...dark }, [1, 1, 1], beta);
  const most = Math.max(...expected);
  for (const k of [0, 1, 2]) {
    expect(Math.abs(drawn[k] - expected[k]) / most).toBeLessThan(0.01);
    expect(Math.abs(dim[k] - expectedDim[k]) / most).toBeLessThan(0.01);
  }
  expect(most).toBeGreaterThan(1.5 * Math.max(...dim));
});

/** A texture channel that is constantly 0.6. */
const CONSTANT_CHANNEL: TextureChannel = { texture: picture([[0, 153, 0]]), channel: 1, scale: 1, bias: 0 };

it.each([
  ['infrared', 0.6, { ir: 0.6 }, { ir: 0.6, irTexture: CONSTANT_CHANNEL }],
  ['ultraviolet', -0.6, { uv: 0.6 }, { uv: 0.6, uvTexture: CONSTANT_CHANNEL }],
] as const)('%s reflectance from a texture equals that of a constant, at %s c', async (_, beta, number, texels) => {
  const material = { baseColor: [0.2, 0.3, 0.1] } as const;
  const [drawn, expected] = await colors({ ...material, ...texels }, [1, 1, 1], beta);
  const [same, expectedSame] = await colors({ ...material, ...number }, [1, 1, 1], beta);
  const most = Math.max(...expected);
  for (const k of [0, 1, 2]) {
    expect(Math.abs(drawn[k] - same[k]) / most).toBeLessThan(3e-3);
    expect(Math.abs(expected[k] - expectedSame[k]) / most).toBeLessThan(1e-6);
  }
});

it('occlusion maps dim sky light in both renderers, but not local lights', async () => {
  const wall = { baseColor: [0.8, 0.8, 0.8] } as const;
  const shelter = { occlusionTexture: { ...CONSTANT_CHANNEL, scale: 0.5, bias: 0.1 } };
  const [open, sheltered] = [await colors(wall, [1, 1, 1], 0), await colors({ ...wall, ...shelter }, [1, 1, 1], 0)];
  for (const [k, bound] of [0.01, 1e-6].entries())
    expect(Math.abs(sheltered[k][1] / open[k][1] - 0.4)).toBeLessThan(bound);
  const light = [lamp([0, 0, 3])];
  const [lit1, lit2] = [
    await colors(wall, ZERO, 0, SETTINGS, light),
    await colors({ ...wall, ...shelter }, ZERO, 0, SETTINGS, light),
  ];
  for (const k of [0, 1]) expect(lit2[k][1] / lit1[k][1]).toBeCloseTo(1, 3);
});
