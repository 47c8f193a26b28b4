import { normalize, sub, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { FOREVER, makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { withMaterial } from '../../../src/scene/mesh/meshOps.ts';
import { box, plane } from '../../../src/scene/mesh/primitives.ts';
import type { Light, Material, Scene, Texture, TextureChannel } from '../../../src/scene/types.ts';
import { lookAtOrientation } from '../../../src/scene/view/camera.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';

export const SIZE = 96;

/** A texture of smooth waves; `phase` distinguishes it from others, `side`: its size [px]. */
function waves(phase: number, [low, high]: readonly [number, number], side = 16): Texture {
  const value = (x: number, y: number) => 0.5 + 0.5 * Math.sin((2 * Math.PI * (x + 2 * y)) / side + phase);
  return {
    name: `waves ${phase}`,
    width: side,
    height: side,
    data: Uint8Array.from({ length: 4 * side * side }, (_, i) =>
      i % 4 === 3 ? 255 : Math.round(low + (high - low) * value((i >> 2) % side, Math.floor(i / 4 / side))),
    ),
    colorSpace: 'linear',
    filter: 'linear',
    wrapS: 'repeat',
    wrapT: 'repeat',
  };
}

const channelOf = (phase: number, side: number): TextureChannel => ({
  texture: waves(phase, [80, 220], side),
  channel: 1,
  scale: 1,
  bias: 0,
});

/** All eight textures of a material, of different sizes. */
const pictured = (name: string, first: number, given: Partial<Material> = {}): Material =>
  makeMaterial({
    name,
    baseColorTexture: waves(first, [90, 230]),
    emissive: [0.05, 0.1, 0.2],
    emissiveTexture: waves(first + 1, [0, 255]),
    normalTexture: { texture: waves(first + 2, [118, 138]), strength: [1, 1] },
    roughnessTexture: channelOf(first + 3, 8),
    metallicTexture: channelOf(first + 4, 16),
    occlusionTexture: channelOf(first + 5, 32),
    uvTexture: channelOf(first + 6, 64),
    irTexture: channelOf(first + 7, 128),
    uv: 0.5,
    ir: 0.5,
    ...given,
  });

const point = { kind: 'sphere', lifetime: FOREVER, radius: 0 } as const;

const LIGHTS: readonly Light[] = [
  { kind: 'distant', path: '/Sun', direction: normalize([0.5, -1, -0.4]), color: [2, 1.4, 1.2] },
  {
    ...point,
    path: '/Lines',
    motion: restingAt([1, 2, 0]),
    color: [4, 4, 4],
    spectrum: { kind: 'lines', lines: [{ wavelength: 589e-9, weight: 1 }] },
  },
  {
    ...point,
    path: '/Warm',
    color: [1, 3, 1],
    spectrum: { kind: 'thermal', temperature: 3000 },
    motion: {
      kind: 'sampled',
      times: Float64Array.of(-20, 20),
      poses: Float64Array.of(...[-6, 1.5, 1], ...[0, 0, 0, 1], ...[6, 1.5, 1], ...[0, 0, 0, 1]),
    },
  },
  {
    kind: 'dome',
    path: '/Sky',
    color: [0.5, 0.5, 0.5],
    texture: { ...waves(0.4, [100, 200]), wrapT: 'clamp' },
  },
];

/** All features of the lighting shader at once: objects at rest and in motion under a coloured sun, lights with a temperature and with spectral lines, a dome texture, and a window in front. */
export const FULL_SCENE: Scene = makeScene({
  name: 'all at once',
  objects: [
    makeObject({ path: '/Floor', mesh: plane(12, 12, 'Y'), motion: restingAt(ZERO) }),
    makeObject({
      path: '/Mover',
      mesh: box([1, 1, 1]),
      motion: { kind: 'uniform', pose: { position: [2.4, 0.8, -1], orientation: [0, 0, 0, 1] }, velocity: [0.4, 0, 0] },
    }),
    makeObject({ path: '/Window', mesh: withMaterial(plane(1.5, 3, 'Z'), 1), motion: restingAt([-0.6, 1, 2]) }),
  ],
  materials: [pictured('opaque', 0), pictured('glass', 8, { opacity: 0.5 })],
  lights: LIGHTS,
});

export const FULL_SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1, grid: false };
const position: Vec3 = [0.5, 2.2, 5];
export const FULL_VIEW: ViewPoint = {
  t: 0,
  position,
  u: [0, 0, -0.3],
  orientation: lookAtOrientation(sub([0, 0.4, 0], position), [0, 1, 0]),
  lens: perspective(1),
};

/** Its linear light. */
export async function fullPicture(renderer: RasterRenderer): Promise<number[]> {
  await renderer.setScene(FULL_SCENE);
  renderer.setSize(SIZE, SIZE);
  renderer.render([FULL_VIEW], FULL_SETTINGS);
  return Array.from(await renderer.readAov('beauty'));
}
