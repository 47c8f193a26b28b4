import { IDENTITY } from '../../../src/math/quat.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import type { FrameGraph } from '../../../src/scene/frameGraph/frameGraph.ts';
import { makeStillPixels } from '../../../src/scene/frameGraph/still.ts';
import { withMaterial } from '../../../src/scene/mesh/meshOps.ts';
import { plane } from '../../../src/scene/mesh/primitives.ts';
import { EQUATORIAL } from '../../../src/scene/stars/equatorial.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';

/** Odd, so that the middle pixel shows the direction straight ahead. */
export const SIZE = 5;

export const EMBER_TEMPERATURE = 1000;

/** A wall that does nothing but glow. */
const wall = (material: Partial<Parameters<typeof makeMaterial>[0]>, opacity: number): Scene =>
  makeScene({
    name: 'wall',
    lights: [{ kind: 'dome', path: '/sky', color: [0, 0, 0] }],
    objects: [makeObject({ path: '/wall', mesh: withMaterial(plane(40, 40), 0), motion: restingAt([0, 0, 0]) })],
    materials: [makeMaterial({ name: 'wall', baseColor: [0, 0, 0], ior: 1, roughness: 1, opacity, ...material })],
  });
/** Of luminance 1 at rest. */
const EMBER = { emissive: [1, 1, 1], emissionTemperature: EMBER_TEMPERATURE } as const;
/** Beyond halves at rest. */
export const BRIGHT: Vec3 = [3e9, 2e8, 8e9];

export const SCENES = {
  ember: wall(EMBER, 1),
  veil: wall(EMBER, 0.5),
  bright: wall({ emissive: BRIGHT }, 1),
  cosmos: makeScene({
    name: 'cosmos',
    objects: [],
    lights: [
      {
        kind: 'stars',
        path: '/stars',
        stars: {
          directions: new Float32Array(0),
          temperatures: new Float32Array(0),
          illuminances: new Float32Array(0),
        },
        orientation: EQUATORIAL,
        gain: 1,
      },
    ],
  }),
} as const;

const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1, shadows: false, occlusionRadius: 0 };
/** The light through a blur, which keeps what is even. */
const BLURRED: FrameGraph = {
  extraBuffers: [],
  passes: [
    { kind: 'light', buffer: 0, shadows: false, occlusion: false },
    { kind: 'effect', effect: 'bloom', args: [0.5, 0.5], image: 0, buffer: 0 },
  ],
};
export const STILL: Vec3 = [4e7, 3e5, 2];
const SHOWN: FrameGraph = {
  extraBuffers: [],
  passes: [
    {
      kind: 'still',
      still: makeStillPixels(
        SIZE,
        SIZE,
        Float32Array.from({ length: 3 * SIZE * SIZE }, (_, i) => STILL[i % 3]),
      ),
    },
  ],
};
export const GRAPHS = { none: undefined, blurred: BLURRED, still: SHOWN } as const;

/** One picture, straight towards the wall with proper velocity u (negative: away from it): the light in its middle, and the meter's reading there. */
export async function middleLight(
  renderer: RasterRenderer,
  scene: keyof typeof SCENES,
  u: number,
  graph: keyof typeof GRAPHS,
  pump: () => void,
): Promise<{ readonly light: readonly number[]; readonly metered: number }> {
  renderer.setSize(SIZE, SIZE);
  await renderer.setScene(SCENES[scene]);
  const view: ViewPoint = { t: 0, position: [0, 0, 5], u: [0, 0, -u], orientation: IDENTITY, lens: perspective(0.001) };
  const frameGraph = GRAPHS[graph];
  pump();
  renderer.render([view], { ...SETTINGS, ...(frameGraph && { frameGraph }) }, 1);
  const beauty = await renderer.readAov('beauty');
  const { luminance } = await renderer.measureLight();
  const at = (SIZE * SIZE - 1) / 2;
  return { light: Array.from(beauty.subarray(3 * at, 3 * at + 3)), metered: luminance[32 * 64 + 32] };
}
