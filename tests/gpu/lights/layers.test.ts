import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import { normalize, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { makeMaterial } from '../../../src/scene/defaults.ts';
import { box, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { DistantLight, Material, Motion } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { dome, lamp, lit } from '../../support/lightKit.ts';
import { compareWithReference, type Difference } from '../support/agreement.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

/* Materials of several layers, drawn over the light of the G-buffer, against the reference renderer. */

const SIZE = 28;
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1 };
const VIEW: ViewPoint = { t: 0, position: [0, 0, 4], u: ZERO, orientation: IDENTITY, lens: perspective(0.7) };
const SUN: DistantLight = {
  kind: 'distant',
  path: '/sun',
  direction: normalize([-0.5, 0.2, -1]),
  color: [3, 2.7, 2],
};

/** A layered ball before a plain wall. */
function compared(material: Partial<Material>, velocity: Vec3, beta: Vec3): Promise<Difference> {
  const moving = (z: number): Motion => ({
    kind: 'uniform',
    pose: { position: [4 * velocity[0], 4 * velocity[1], z + 4 * velocity[2]], orientation: IDENTITY },
    velocity,
  });
  const scene = lit(
    [
      {
        mesh: sphere(1, { segments: 48 }),
        material: makeMaterial({ name: 'ball', baseColor: [0.7, 0.2, 0.1], roughness: 0.7, ...material }),
        motion: moving(0),
      },
      // So far that the ball's shadows, whose edges are compared elsewhere, are not in the picture.
      { mesh: plane(60, 60), material: makeMaterial({ name: 'wall', roughness: 0.9 }), motion: moving(-20) },
    ],
    [SUN, lamp([3, 3, 3], { color: [40, 50, 60] })],
  );
  return compareWithReference(headless, scene, { ...VIEW, u: properVelocity(beta) }, SETTINGS, 24);
}

/** The fast renderer knows the colours of a film by five bands, which a shift moves as wholes, and what grooves lose between microfacets by their mean roughness. */
const LEAST_EXACT: readonly (readonly [layer: keyof Material, most: number])[] = [
  ['iridescence', 0.1],
  ['sheen', 0.07],
  ['anisotropy', 0.05],
];

describe('the rasterizer shows as the reference', () => {
  it.each([
    [
      'a soap film on black',
      { baseColor: [0, 0, 0], roughness: 0.35, iridescence: { factor: 1, ior: 1.33, thickness: [0, 350e-9] } },
    ],
    [
      'fuzz under a varnish',
      {
        sheen: { color: [0.9, 0.6, 0.3], roughness: 0.5 },
        clearcoat: { factor: 0.5, roughness: 0.4 },
      },
    ],
    ['brushed metal', { metallic: 1, roughness: 0.3, anisotropy: { strength: 0.8, rotation: 0.7 } }],
    [
      'a varnish over a tinted reflection of a half metal that glows',
      {
        clearcoat: { factor: 1, roughness: 0.4 },
        specular: { factor: 1, color: [0.1, 3, 3] },
        metallic: 0.5,
        emissive: [0.1, 0.2, 0.3],
      },
    ],
  ] as readonly (readonly [string, Partial<Material>])[])('%s, at rest and moving', async (_, material) => {
    for (const [velocity, beta] of [
      [ZERO, ZERO],
      [
        [0.3, 0.2, 0.1],
        [0.1, 0, -0.2],
      ],
    ] as const) {
      const { mean, max } = await compared(material, velocity, beta);
      expect(mean).toBeLessThan(0.003);
      expect(max).toBeLessThan(LEAST_EXACT.find(([layer]) => layer in material)?.[1] ?? 0.03);
    }
  });
});

describe('glass shows what is behind it as the reference', () => {
  /** Glass on a wall of four emitting bands, all moving. */
  function throughGlass(material: Partial<Material>, velocity: Vec3, beta: Vec3): Promise<Difference> {
    const moving = (x: number, y: number, z: number): Motion => ({
      kind: 'uniform',
      pose: { position: [x + 4 * velocity[0], y + 4 * velocity[1], z + 4 * velocity[2]], orientation: IDENTITY },
      velocity,
    });
    const bands = [
      [0.8, 0.1, 0.1],
      [0.1, 0.6, 0.2],
      [0.2, 0.2, 0.9],
      [0.7, 0.7, 0.6],
    ].map(([r, g, b], i) => ({
      mesh: plane(1, 4),
      material: makeMaterial({ name: 'band', baseColor: [0, 0, 0], ior: 1, emissive: [r, g, b] }),
      motion: moving(i - 1.5, 0, -1),
    }));
    const glass = makeMaterial({ name: 'glass', baseColor: [1, 1, 1], roughness: 0, ...material });
    const block = { mesh: box([2, 2, 0.98]), material: glass, motion: moving(0, 0, -0.5) };
    return compareWithReference(
      headless,
      lit([...bands, block], []),
      { ...VIEW, position: [1.5, 1, 4], orientation: fromAxisAngle([0, 1, 0], 0.35), u: properVelocity(beta) },
      SETTINGS,
      16,
    );
  }
  it.each([
    ['a thin tinted sheet', { transmission: { factor: 0.9 }, baseColor: [0.4, 0.8, 0.9] }],
    [
      'a thick block that absorbs',
      {
        transmission: { factor: 1 },
        volume: { thickness: 0.98, attenuationColor: [0.9, 0.5, 0.4], attenuationDistance: 0.7 },
      },
    ],
  ] as readonly (readonly [string, Partial<Material>])[])('through %s, at rest and moving', async (_, material) => {
    for (const [velocity, beta] of [
      [ZERO, ZERO],
      [
        [0.2, 0.1, 0.2],
        [0.1, 0, -0.1],
      ],
    ] as const) {
      const { mean } = await throughGlass(material, velocity, beta);
      // The fast renderer takes the thickness for the way of the ray.
      expect(mean).toBeLessThan(0.035);
    }
  });
});

it.each(['of its material', 'of its vertices'])(
  'an unlit surface shows the colour %s as it is written, and shifts when it moves',
  async (from) => {
    const orange = [255, 128, 0];
    const emissive = orange.map((x) => ((x / 255 + 0.055) / 1.055) ** 2.4).map((x) => (x < 0.001 ? 0 : x));
    const [r, g, b] = emissive;
    const sign = plane(20, 20);
    const isPainted = from === 'of its vertices';
    const colors = Float32Array.from(sign.positions, (_, i) => emissive[i % 3] / 2);
    const unlit = makeMaterial({
      name: 'sign',
      baseColor: [0, 0, 0],
      emissive: isPainted ? [2, 2, 2] : [r, g, b],
      ior: 1,
      unlit: true,
    });
    const { scene } = lit([{ mesh: isPainted ? { ...sign, colors } : sign, material: unlit }], [SUN, dome([1, 1, 1])]);
    const { renderer } = headless;
    await renderer.setScene(scene);
    const shown = async (beta: Vec3, settings: Partial<RenderSettings>): Promise<readonly number[]> => {
      renderer.render([{ ...VIEW, u: properVelocity(beta) }], { ...SETTINGS, ...settings }, 1);
      const pixels = await renderer.readPixels();
      const at = 4 * (SIZE * (SIZE / 2) + SIZE / 2);
      return [...pixels.subarray(at, at + 3)];
    };
    const far = (seen: readonly number[]): number => Math.max(...seen.map((x, k) => Math.abs(x - orange[k])));
    // The picture is dithered by half a step.
    expect(far(await shown(ZERO, {}))).toBeLessThanOrEqual(1);
    // Where nothing is shifted, it may fly.
    expect(far(await shown([0, 0, -0.5], { dopplerMix: 0, beaming: 0 }))).toBeLessThanOrEqual(1);
    expect(far(await shown([0, 0, -0.1], {}))).toBeGreaterThan(10);
  },
);
