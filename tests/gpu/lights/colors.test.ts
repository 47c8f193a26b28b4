import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY } from '../../../src/math/quat.ts';
import { add, normalize, scale, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { pixelSequence } from '../../../src/reference/sampling/pixelSequence.ts';
import { radiance } from '../../../src/reference/transport/path.ts';
import { SKY_LIGHTS } from '../../../src/render/color/daylightTable.ts';
import { makeMaterial } from '../../../src/scene/defaults.ts';
import { DAY_SKY } from '../../../src/scene/lights/sceneLights.ts';
import { plane } from '../../../src/scene/mesh/primitives.ts';
import type { DistantLight, Light, Material, Motion, SceneObject } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { colorOfSpectrum, observedColor } from '../../../src/spectrum/color/observerColor.ts';
import { skyParts } from '../../../src/spectrum/color/scatteredLight.ts';
import { RGB_COLOR_MODES, RGB_SHIFTS } from '../../../src/spectrum/doppler/rgbShifts.ts';
import { filterFromRgb, WHITE_FILTER } from '../../../src/spectrum/reflectance/spectralFilter.ts';
import { LIGHT_PRESETS } from '../../../src/spectrum/sources/lightPresets.ts';
import { DAYLIGHT, type LightSpectrum } from '../../../src/spectrum/sources/lightSpectrum.ts';
import { DIRECT, dome, lamp, lit } from '../../support/lightKit.ts';
import { compareWithReference, type Difference } from '../support/agreement.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = 32;
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1 };
/** Straight down on six tiles of different colours, slightly emissive. */
const VIEW: ViewPoint = { t: 0, position: [0, 0, 3], u: ZERO, orientation: IDENTITY, lens: perspective(1.2) };
const COLORS: readonly Vec3[] = [
  [0.9, 0.9, 0.9],
  [0.8, 0.1, 0.05],
  [0.1, 0.6, 0.1],
  [0.05, 0.1, 0.7],
  [0.8, 0.7, 0.1],
  [0.2, 0.2, 0.2],
];

const tiles = (
  velocity: Vec3 | undefined,
  given: Partial<Material> = {},
): (Partial<SceneObject> & { mesh: SceneObject['mesh']; material: Material })[] =>
  COLORS.map((baseColor, i) => {
    const pose = { position: [1.4 * ((i % 3) - 1), 1.9 * ((i < 3 ? 0 : 1) - 0.5), 0] as Vec3, orientation: IDENTITY };
    const motion: Motion = velocity
      ? {
          kind: 'uniform',
          pose: {
            ...pose,
            position: [
              pose.position[0] + 3 * velocity[0],
              pose.position[1] + 3 * velocity[1],
              pose.position[2] + 3 * velocity[2],
            ],
          },
          velocity,
        }
      : { kind: 'static', pose };
    return {
      mesh: plane(1.4, 1.9),
      material: makeMaterial({ name: `${i}`, baseColor, roughness: 0.9, ...given }),
      motion,
    };
  });

const sun = (color: Vec3, spectrum?: LightSpectrum): DistantLight => ({
  kind: 'distant',
  path: '/sun',
  direction: normalize([-0.5, 0.2, -1]),
  color,
  ...(spectrum && { spectrum }),
});

interface Case {
  /** Velocities of the observer and of the tiles [c]. */
  readonly beta?: Vec3;
  readonly velocity?: Vec3;
  readonly material?: Partial<Material>;
  readonly settings?: Partial<RenderSettings>;
}
const compared = (lights: readonly Light[], { beta = ZERO, velocity, material, settings }: Case): Promise<Difference> =>
  compareWithReference(
    headless,
    lit(tiles(velocity, material), lights),
    { ...VIEW, u: properVelocity(beta) },
    { ...SETTINGS, ...settings },
    48,
  );

describe('the rasterizer shows the colours of the spectral reference', () => {
  const BETAS: readonly Vec3[] = [
    [0, 0, -0.3],
    [0, 0, 0.3],
    [0.4, 0, -0.5],
  ];
  it.each(BETAS)('in white daylight, at %f %f %f c', async (...beta) => {
    const { mean, max: most } = await compared([sun([3, 3, 3])], { beta });
    expect(mean).toBeLessThan(0.003);
    expect(most).toBeLessThan(0.015);
  });

  it.each([3000, 12_000])('by a light of %f K, at 0.3 c', async (temperature) => {
    const spectrum = { kind: 'thermal', temperature } as const;
    const light = lamp([0.5, 0.3, 1.5], { color: scale(colorOfSpectrum(spectrum), 5), spectrum });
    const { mean, max: most } = await compared([light], { beta: [0, 0, 0.3] });
    expect(mean).toBeLessThan(0.003);
    expect(most).toBeLessThan(0.015);
    // With a filter that makes it white.
    const white = await compared([{ ...light, color: [5, 5, 5] }], { beta: [0, 0, 0.3] });
    expect(white.mean).toBeLessThan(0.004);
    expect(white.max).toBeLessThan(0.02);
  });

  it.each(['sodium', 'mercury', 'led'])('by a moving light of %s on moving tiles', async (name) => {
    const spectrum = LIGHT_PRESETS.get(name)!.spectrum;
    const pose = { position: [-0.4, 0.3, 1.5], orientation: IDENTITY } as const;
    const motion = { kind: 'uniform', pose, velocity: [0.3, 0, 0] } as const;
    const light = lamp([0, 0, 0], { color: [5, 5, 5], spectrum, motion });
    const { mean, max: most } = await compared([light, sun([1, 1, 1], spectrum)], {
      velocity: [0.3, 0.2, 0.2],
      beta: [0.1, 0, 0],
    });
    // Reflectances are steep where a line meets the edge of a band.
    expect(mean).toBeLessThan(0.015);
    expect(most).toBeLessThan(0.1);
  });

  it('on moving tiles, exactly in white daylight', async () => {
    const { mean, max: most } = await compared([sun([3, 3, 3])], { velocity: [0.3, 0.2, 0.2], beta: [0.1, 0, 0] });
    expect(mean).toBeLessThan(0.003);
    expect(most).toBeLessThan(0.015);
  });

  it.each([
    ['rest, seen at rest', {}],
    ['rest, seen by one who flies', { beta: [0.4, 0, -0.5] }],
    ['fly', { velocity: [0.3, 0.2, 0.2], beta: [0.1, 0, 0] }],
    ['fly, and tell of their invisible', { velocity: [0.3, 0.2, -0.2], material: { uv: 0.05, ir: 0.9 } }],
  ] as const)('in strongly coloured light, on tiles that %s', async (_, given) => {
    const { mean, max: most } = await compared(
      [sun([3, 0.6, 0.1]), lamp([0.5, 0.3, 1.5], { color: [0.2, 1, 4] })],
      given,
    );
    expect(mean).toBeLessThan(0.003);
    expect(most).toBeLessThan(0.02);
  });

  it('of materials with ultraviolet and infrared coefficients', async () => {
    for (const z of [-0.4, 0.4]) {
      const { mean, max: most } = await compared([sun([3, 3, 3])], {
        beta: [0, 0, z],
        material: { uv: 0.05, ir: 0.9 },
      });
      expect(mean).toBeLessThan(0.004);
      expect(most).toBeLessThan(0.02);
    }
  });

  it('of emissive materials with a temperature', async () => {
    const material = { emissive: [1, 1, 1] as const, emissionTemperature: 2500 };
    const { mean, max: most } = await compared([sun([1, 1, 1])], { beta: [0, 0, -0.3], material });
    expect(mean).toBeLessThan(0.006);
    expect(most).toBeLessThan(0.02);
  });

  it.each(['candle', 'mercury'])('of a sky of %s', async (name) => {
    const spectrum = LIGHT_PRESETS.get(name)!.spectrum;
    const sky = { ...dome(colorOfSpectrum(spectrum)), spectrum };
    const view = { ...VIEW, u: properVelocity([0.2, 0, 0.3]) };
    const { mean, max: most } = await compareWithReference(headless, lit([], [sky]), view, SETTINGS, 16);
    expect(mean).toBeLessThan(0.004);
    expect(most).toBeLessThan(0.02);
  });

  it('of a blue sky with the explicit spectrum daylight, without scattering', async () => {
    const view = { ...VIEW, u: properVelocity([0.2, 0, 0.3]) };
    const blue = { ...dome([0.2, 0.4, 1]), spectrum: DAYLIGHT };
    const { mean, max: most } = await compareWithReference(headless, lit([], [blue]), view, SETTINGS, 16);
    expect(mean).toBeLessThan(0.004);
    expect(most).toBeLessThan(0.02);
  });

  it.each([
    ['blue', DAY_SKY.color],
    ['hazy', DAY_SKY.gradient.horizon],
    ['red', [0.8, 0.35, 0.1]],
  ] as const)('of a %s sky', async (_, color) => {
    const view = { ...VIEW, u: properVelocity([0.2, 0, 0.3]) };
    const { mean, max: most } = await compareWithReference(headless, lit([], [dome(color)]), view, SETTINGS, 16);
    expect(mean).toBeLessThan(0.004);
    expect(most).toBeLessThan(0.02);
  });

  it.each<readonly [string, Vec3, Vec3]>([
    ['blue', [0.3, 0.5, 1], [0, 0, -0.4]],
    ['red', [1, 0.3, 0.04], [0, 0, -0.4]],
    ['red', [1, 0.3, 0.04], ZERO],
  ])('of matt tiles under a %s sky, by integration', async (_, color, beta) => {
    await headless.renderer.setScene(lit(tiles(undefined, { ior: 1, roughness: 1 }), [dome(color)]).scene);
    pumpFrame();
    headless.renderer.render([{ ...VIEW, u: properVelocity(beta) }], { ...SETTINGS, occlusionRadius: 0 }, 1);
    const drawn = await headless.renderer.readAov('beauty');
    const dopplers = await headless.renderer.readAov('doppler');
    const { scattered, reddened, rest } = skyParts(color);
    // The tiles above and below the middle.
    for (const [row, albedo] of [
      [SIZE / 2 - 5, COLORS[4]],
      [SIZE / 2 + 4, COLORS[1]],
    ] as const) {
      const at = row * SIZE + SIZE / 2;
      const D = dopplers[at];
      const seen = (of: Vec3): Vec3 =>
        [scattered, ...reddened]
          .map((share, i) => scale(observedColor(filterFromRgb(of), WHITE_FILTER, SKY_LIGHTS[i].spectrum, 1, D), share))
          .reduce(add, observedColor(filterFromRgb(of), filterFromRgb(rest), DAYLIGHT, 1, D));
      const [exact, white] = [seen(albedo), Math.max(...seen([1, 1, 1]))];
      exact.forEach((value, k) => {
        expect(Math.abs(drawn[3 * at + k] / D ** 4 - value) / white).toBeLessThan(0.01);
      });
    }
  });

  it('with partial Doppler shifts', async () => {
    const { mean, max: most } = await compared([sun([3, 3, 3])], {
      beta: [0, 0, -0.5],
      velocity: [0, 0.4, 0],
      settings: { dopplerMix: 0.4, beaming: 0.6 },
    });
    expect(mean).toBeLessThan(0.004);
    expect(most).toBeLessThan(0.02);
  });

  it.each(RGB_COLOR_MODES)('and the reference’s colours without spectra, %s', async (colors) => {
    const { mean, max: most } = await compared([sun([3, 2, 1])], {
      beta: [0, 0, -0.3],
      velocity: [0, 0.4, 0],
      settings: { colors },
    });
    expect(mean).toBeLessThan(0.002);
    // Shifted lines change by hundredths per nanometre, and SwiftShader's interpolation moves D by up to 0.2 % in so small a picture.
    expect(most).toBeLessThan(colors === 'approximate' ? 0.015 : 0.08);
  });

  it.each(RGB_COLOR_MODES)('a sun and a sky of other colours, shifted each by itself, %s', async (colors) => {
    const [light, sky] = [sun([2, 1.1, 0.3]), [0.1, 0.25, 0.5] as Vec3];
    const scene = lit(tiles(undefined, { ior: 1, roughness: 1 }), [light, dome(sky)]);
    const [settings, u] = [{ ...SETTINGS, colors }, properVelocity([0, 0, -0.2])];
    await headless.renderer.setScene(scene.scene);
    pumpFrame();
    headless.renderer.render([{ ...VIEW, u }], { ...settings, occlusionRadius: 0 }, 1);
    const [drawn, dopplers] = [await headless.renderer.readAov('beauty'), await headless.renderer.readAov('doppler')];
    const cosine = -light.direction[2];
    // Above and below the middle.
    for (const [row, albedo] of [
      [SIZE / 2 - 5, COLORS[4]],
      [SIZE / 2 + 4, COLORS[1]],
    ] as const) {
      const at = row * SIZE + SIZE / 2;
      const D = dopplers[at];
      const seen = (from: Vec3, share: number): Vec3 =>
        RGB_SHIFTS[colors](
          [share * albedo[0] * from[0], share * albedo[1] * from[1], share * albedo[2] * from[2]],
          D,
          1,
        );
      const exact = scale(add(seen(light.color, cosine / Math.PI), seen(sky, 1)), D ** 4);
      const ray = cameraRay({ ...VIEW, u }, settings, SIZE / 2 + 0.5, row + 0.5, SIZE, SIZE)!;
      const traced = radiance(scene, ray, { u }, settings, { ...DIRECT, bounces: 1 }, pixelSequence(1, 0, 0)(0));
      exact.forEach((value, k) => {
        expect(Math.abs(drawn[3 * at + k] - value)).toBeLessThan(0.005 * Math.max(...exact));
        expect(Math.abs(traced[k] - value)).toBeLessThan(0.005 * Math.max(...exact));
      });
    }
  });
});
