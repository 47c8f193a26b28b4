import { fromAxisAngle } from '../../../src/math/quat.ts';
import { addScaled, length, normalize, sub, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { apparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import { simultaneousPosition } from '../../../src/physics/worldLines/simultaneity.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { withMaterial } from '../../../src/scene/mesh/meshOps.ts';
import { box, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { DistantLight, Motion, Scene, SceneObject, Texture } from '../../../src/scene/types.ts';
import { lookAtOrientation } from '../../../src/scene/view/camera.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';

export const SIZE = 128;

/** Objects on a floor under a sun, without sky. */
export interface ShadowScene {
  readonly name: string;
  readonly scene: Scene;
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
}

const SUN: DistantLight = { kind: 'distant', path: '/Sun', direction: normalize([0.5, -1, -0.4]), color: [3, 3, 3] };
const OTHER: DistantLight = { ...SUN, path: '/Other', direction: normalize([-0.7, -1, 0.2]), color: [2, 2, 2] };

/** A checkerboard whose alternate squares are cut out. */
const HOLES: Texture = {
  name: 'holes',
  width: 64,
  height: 64,
  data: Uint8Array.from({ length: 4 * 64 * 64 }, (_, i) => {
    const [x, y] = [(i >> 2) & 63, i >> 8];
    return i % 4 === 3 && ((x >> 4) + (y >> 4)) % 2 === 0 ? 0 : 255;
  }),
  colorSpace: 'linear',
  filter: 'nearest',
  wrapS: 'repeat',
  wrapT: 'repeat',
};

const MATERIALS = [
  makeMaterial({ name: 'grey', baseColor: [0.6, 0.6, 0.6], roughness: 1 }),
  makeMaterial({ name: 'lattice', opacityThreshold: 0.5, baseColorTexture: HOLES }),
];

const FLOOR = makeObject({ path: '/Floor', mesh: plane(40, 40, 'Y'), motion: restingAt(ZERO) });
const TURN = fromAxisAngle([0, 1, 0], 0.5);
const BOX = box([1.4, 1.6, 1]);
/** Above the floor's centre at the time −`delay`, when it is seen from the usual position. */
const flying = (velocity: Vec3, delay = 9.5): Motion => ({
  kind: 'uniform',
  pose: { position: addScaled([0, 1.6, 0], velocity, delay), orientation: TURN },
  velocity,
});
const turning = (): Motion => ({
  kind: 'sampled',
  times: Float64Array.of(-30, 10),
  poses: Float64Array.of(...[-6, 1.5, -2], ...TURN, ...[4, 1.5, 0.5], ...TURN),
});

function shadowScene(
  name: string,
  objects: readonly (Partial<SceneObject> & Pick<SceneObject, 'mesh'>)[],
  { beta = ZERO, lights = [SUN], ...change }: Partial<RenderSettings> & { beta?: Vec3; lights?: Scene['lights'] } = {},
): ShadowScene {
  const scene = makeScene({
    name,
    objects: [FLOOR, ...objects.map((object, k) => makeObject({ path: `/Thing${k}`, ...object }))],
    materials: MATERIALS,
    lights: [...lights, { kind: 'dome', path: '/Dark', color: [0, 0, 0] }],
  });
  const position: Vec3 = [1.5, 5, 8];
  const u = properVelocity(beta);
  const settings: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1, colors: 'approximate', ...change };
  const place = change.view === 'simultaneity' ? simultaneousPosition : apparentPosition;
  const shown = place(sub([0.8, 0.3, -0.5], position), u);
  const fovY = 2 * Math.atan(2.2 / length(shown));
  return {
    name,
    scene,
    settings,
    view: { t: 0, position, u, orientation: lookAtOrientation(shown, [0, 1, 0]), lens: perspective(fovY) },
  };
}

const resting = { mesh: BOX, motion: { kind: 'static', pose: { position: [0, 1.2, 0], orientation: TURN } } } as const;
const fast: Vec3 = [0.7, 0, -0.387];

export const SHADOW_SCENES: readonly ShadowScene[] = [
  shadowScene('a resting box', [resting]),
  shadowScene('the same, seen at 0.9 c', [resting], { beta: [0.3, -0.4, -0.748] }),
  shadowScene('a ball on the floor', [{ mesh: sphere(1, { segments: 96, rings: 48 }), motion: restingAt([0, 1, 0]) }]),
  shadowScene('a lattice', [{ mesh: withMaterial(plane(4, 4, 'Y'), 1), motion: restingAt([0.3, 1.5, 0]) }]),
  shadowScene('two suns', [resting], { lights: [SUN, OTHER] }),
  shadowScene('a box at 0.8 c', [{ mesh: BOX, motion: flying(fast) }]),
  shadowScene('a box of its own frame at 0.8 c', [{ mesh: BOX, motion: flying(fast), authoredIn: 'rest' }]),
  shadowScene('both at speed', [{ mesh: BOX, motion: flying(fast) }, resting], { beta: [0.3, -0.4, -0.748] }),
  shadowScene('along samples', [{ mesh: BOX, motion: turning() }]),
  shadowScene('at the observer’s own instant', [{ mesh: BOX, motion: flying(fast, -5.4) }], {
    view: 'simultaneity',
    beta: [0.3, -0.1, -0.6],
  }),
  shadowScene('at one instant of the world', [{ mesh: BOX, motion: flying(fast, 0) }], { lightDelay: false }),
];

/** Height of a projectile thrown upwards, highest when it is seen from the usual position [m]. */
const thrown = (t: number): number => 2.2 - 0.075 * (t + 9.5) ** 2;
const TIMES = Float64Array.from({ length: 91 }, (_, k) => -14 + 0.1 * k);
const SHEET = plane(2.4, 2.4, 'Y');

/** Objects that accelerate while light crosses them: deforming and rigid. */
export const PROJECTILE_SCENES: readonly ShadowScene[] = [
  shadowScene('a thrown sheet', [
    {
      mesh: SHEET,
      motion: {
        kind: 'sampled-points',
        times: TIMES,
        origin: ZERO,
        points: Array.from(TIMES, (t) => SHEET.positions.map((x, i) => (i % 3 === 1 ? thrown(t) : x))),
      },
    },
  ]),
  shadowScene('a thrown ball', [
    {
      mesh: sphere(1, { segments: 96, rings: 48 }),
      motion: {
        kind: 'sampled',
        times: TIMES,
        poses: Float64Array.from(Array.from(TIMES, (t) => [0, thrown(t), 0, 0, 0, 0, 1]).flat()),
      },
    },
  ]),
];

/** A sheet with one edge above x = 0 under a sun overhead, whose disc, projected past the edge onto the floor, has the given width [m]. */
export function penumbraScene(radius: number, height: number): ShadowScene {
  const sun: DistantLight = { ...SUN, direction: [0, -1, 0], angle: 2 * Math.atan(radius / height) };
  const sheet = { mesh: plane(4, 4, 'Y'), motion: restingAt([2, height, 0]) };
  const made = shadowScene('a penumbra', [sheet], { lights: [sun] });
  const position: Vec3 = [0, 0.8, 0.6];
  const orientation = lookAtOrientation(sub(ZERO, position), [0, 1, 0]);
  return { ...made, view: { ...made.view, position, orientation, lens: perspective(0.6) } };
}

/** Fraction of the sunlight that shadows leave per pixel; −1 where there is none without shadows. */
export async function renderSunVisibility(
  renderer: RasterRenderer,
  { scene, view, settings }: ShadowScene,
): Promise<number[]> {
  await renderer.setScene(scene);
  if (renderer.width !== SIZE || renderer.height !== SIZE) renderer.setSize(SIZE, SIZE);
  renderer.render([view], { ...settings, shadows: false });
  const open = await renderer.readAov('beauty');
  renderer.render([view], settings);
  const light = await renderer.readAov('beauty');
  return Array.from({ length: SIZE * SIZE }, (_, i) =>
    open[3 * i + 1] > 1e-4 ? light[3 * i + 1] / open[3 * i + 1] : -1,
  );
}
