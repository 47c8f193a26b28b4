import { fromAxisAngle, IDENTITY, multiply, type Quat } from '../../../src/math/quat.ts';
import { addScaled, scale, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { makeMaterial, makeObject, makeScene } from '../../../src/scene/defaults.ts';
import { grid, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { Mesh, Motion, Scene, SceneObject, Texture } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { DATA_SETTINGS } from '../support/dataSettings.ts';

export const SIZE = 128;
const C = 10;

/** An object with a normal map, viewed along −Z. */
export interface NormalScene {
  readonly name: string;
  readonly scene: Scene;
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** Bound on the median angle to the reference's normals [rad]. */
  readonly tolerance: number;
}

/** Waves, different along u and v, up to 35° steep; with 64 texels per wave, wider than pixels, so that filtering does not blur. */
const WAVES: Texture = {
  name: 'waves',
  width: 64,
  height: 64,
  data: Uint8Array.from({ length: 4 * 64 * 64 }, (_, i) => {
    const [x, y] = [((i >> 2) & 63) / 64, (i >> 8) / 64];
    const [nx, ny] = [0.55 * Math.sin(2 * Math.PI * x), 0.35 * Math.cos(2 * Math.PI * y)];
    const nz = Math.sqrt(1 - nx * nx - ny * ny);
    return i % 4 === 3 ? 255 : Math.round(127.5 * ([nx, ny, nz][i % 4] + 1));
  }),
  colorSpace: 'linear',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'repeat',
};

const AHEAD: Vec3 = [0.5, 0.1, -0.8];

function normalScene(
  name: string,
  object: Partial<SceneObject> & { readonly mesh: Mesh },
  given: { readonly u?: Vec3; readonly settings?: Partial<RenderSettings>; readonly tolerance?: number } = {},
): NormalScene {
  const scene = makeScene({
    name,
    objects: [makeObject({ path: '/Thing', ...object })],
    materials: [makeMaterial({ name: 'waves', normalTexture: { texture: WAVES, strength: [1, -0.8] } })],
  });
  const view = { t: 0, position: ZERO, u: given.u ?? ZERO, orientation: IDENTITY, lens: perspective(1) };
  const settings = { ...DATA_SETTINGS, speedOfLight: C, ...given.settings };
  return { name, scene, view, settings, tolerance: given.tolerance ?? 2e-3 };
}

const TILT: Quat = fromAxisAngle([1, 1, 0.2], 0.7);
/** Seen 6 m ahead, after the light travel time. */
const uniform = (velocity: Vec3): Motion => ({
  kind: 'uniform',
  pose: { position: addScaled([0, 0, -6], velocity, 6 / C), orientation: TILT },
  velocity,
});
const wide = plane(40, 40);
const wall: Mesh = { ...wide, uvs: wide.uvs.map((x) => 4 * x) };
/** Few waves, for distant and slanted surfaces, where mipmaps would matter; oblique to the motions. */
const fewWaves: Mesh = {
  ...wide,
  uvs: wide.uvs.map((x, i) => 0.5 * (i % 2 === 0 ? x + wide.uvs[i + 1] : x - wide.uvs[i - 1])),
};
/** With u reversed. */
const mirrored: Mesh = { ...wall, uvs: wall.uvs.map((x, i) => (i % 2 === 0 ? -x : x)) };

const turning: Motion = {
  kind: 'sampled',
  times: Float64Array.from({ length: 60 }, (_, k) => -3 + k / 10),
  poses: Float64Array.from(
    Array.from({ length: 60 }, (_, k) => {
      const t = -3 + k / 10;
      return [2 * t, 0, -5, ...multiply(fromAxisAngle([0, 1, 0], 0.8 * t), TILT)];
    }).flat(),
  ),
};

function waving(): Partial<SceneObject> & { readonly mesh: Mesh } {
  const mesh = grid(8, 8, 10, 10);
  const times = Float64Array.from({ length: 40 }, (_, k) => -2 + k / 10);
  const points = Array.from(times, (t) =>
    mesh.positions.map((x, i) => (i % 3 === 2 ? 0.5 * Math.sin(0.9 * mesh.positions[i - 2] - 4 * t) : x + 0.3 * t)),
  );
  return { mesh, motion: { kind: 'sampled-points', times, origin: [0, 0, -5], points } };
}

const rushing = scale([0.85, -0.1, 0.1], C);

export const NORMAL_SCENES: readonly NormalScene[] = [
  normalScene('a resting wall', {
    mesh: wall,
    motion: { kind: 'static', pose: { position: [0, 0, -6], orientation: TILT } },
  }),
  normalScene('the same, u mirrored', { mesh: mirrored, motion: uniform(ZERO) }),
  normalScene('a wall of the world at 0.86 c', { mesh: fewWaves, motion: uniform(rushing) }),
  normalScene('a wall of its own frame at 0.86 c', { mesh: fewWaves, motion: uniform(rushing), authoredIn: 'rest' }),
  normalScene('both at speed', { mesh: fewWaves, motion: uniform(rushing) }, { u: properVelocity(scale(AHEAD, 0.9)) }),
  normalScene(
    'at the observer’s own instant',
    { mesh: fewWaves, motion: uniform(rushing) },
    { u: properVelocity(scale(AHEAD, 0.6)), settings: { view: 'simultaneity' } },
  ),
  normalScene('a ball at 0.86 c', { mesh: sphere(2, { segments: 48 }), motion: uniform(rushing) }),
  normalScene('a wall that turns', { mesh: wall, motion: turning }, { tolerance: 4e-3 }),
  normalScene('a cloth', waving()),
];

/** The normals of a picture, 3 numbers per pixel. */
export async function renderNormals(
  renderer: RasterRenderer,
  { scene, view, settings }: NormalScene,
): Promise<number[]> {
  await renderer.setScene(scene);
  if (renderer.width !== SIZE || renderer.height !== SIZE) renderer.setSize(SIZE, SIZE);
  renderer.render([view], settings);
  return Array.from(await renderer.readAov('normal'));
}
