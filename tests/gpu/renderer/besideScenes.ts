import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import { normalize, type Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import type { Sampling } from '../../../src/render/settings.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { withMaterial } from '../../../src/scene/mesh/meshOps.ts';
import { box, grid, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { SampledPointsMotion, Scene, Texture } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { PictureSize } from '../../../src/scene/view/pictureSize.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { renderLoaded } from '../../support/renderLoaded.ts';

/** Of a size that nothing else has. */
export const CHECKS: Texture = {
  name: 'checks',
  width: 37,
  height: 23,
  data: Uint8Array.from({ length: 4 * 37 * 23 }, (_, i) => (i % 4 === 3 ? 255 : (i * 2654435761) >>> 24)),
  colorSpace: 'srgb',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'repeat',
};

const cloth = grid(1.6, 1.6, 24, 24);
const TIMES = Float64Array.from({ length: 90 }, (_, k) => 0.1 * k);
/** Texels for samples: for 40 of the 90 (rows of 1024 texels). */
export const FEW_TEXELS = 40 * 1024;

const flapping: SampledPointsMotion = {
  kind: 'sampled-points',
  times: TIMES,
  origin: [-1.4, 0.9, -4],
  points: Array.from(TIMES, (t) =>
    cloth.positions.map((x, i) => (i % 3 === 2 ? 0.15 * Math.sin(3 * t + 4 * cloth.positions[i - 2]) : x)),
  ),
};
const ball = sphere(0.22, { segments: 16, rings: 12 });

/** With all that is uploaded in another way: what rests and is textured, many of one mesh, what flaps, moves, is varnished or transparent, and pieces that take turns. */
export const SCENE: Scene = makeScene({
  name: 'beside',
  objects: [
    makeObject({ path: '/Floor', mesh: withMaterial(plane(20, 20, 'Y'), 1), motion: restingAt([0, -1, -5]) }),
    makeObject({ path: '/Cloth', mesh: cloth, motion: flapping }),
    ...Array.from({ length: 9 }, (_, i) =>
      makeObject({ path: `/Ball${i}`, mesh: ball, motion: restingAt([0.5 * (i - 4), -0.7, -3.5 - 0.2 * i]) }),
    ),
    makeObject({
      path: '/Fast',
      mesh: withMaterial(sphere(0.5, { segments: 96, rings: 64 }), 3),
      motion: { kind: 'uniform', pose: { position: [0.5, 0.3, -4], orientation: IDENTITY }, velocity: [0.4, 0, 0] },
    }),
    makeObject({ path: '/Veil', mesh: withMaterial(sphere(0.5), 2), motion: restingAt([1, 0.1, -2.8]) }),
    ...[0, 1].map((i) =>
      makeObject({
        path: `/Turn/piece${i}`,
        pieceOf: '/Turn',
        mesh: box([0.5, 0.5 + 0.2 * i, 0.5]),
        motion: restingAt([-0.4, 0.1, -3]),
        lifetime: i ? { birth: 0, death: Number.POSITIVE_INFINITY } : { birth: Number.NEGATIVE_INFINITY, death: 0 },
      }),
    ),
  ],
  materials: [
    makeMaterial({ name: 'matt', baseColor: [0.7, 0.6, 0.5], roughness: 0.8 }),
    makeMaterial({ name: 'checked', baseColor: [1, 1, 1], baseColorTexture: CHECKS }),
    makeMaterial({ name: 'veil', baseColor: [0.2, 0.4, 0.8], opacity: 0.5 }),
    makeMaterial({ name: 'varnished', baseColor: [0.6, 0.1, 0.1], clearcoat: { factor: 1, roughness: 0.1 } }),
  ],
  lights: [{ kind: 'distant', path: '/Sun', direction: normalize([0.4, -1, -0.3]), color: [2, 1.9, 1.7] }],
});

/** With a mesh that is large beside what each picture needs of its own: patches, and casters of shadows. */
export const LARGE: Scene = {
  ...SCENE,
  objects: [
    ...SCENE.objects,
    makeObject({
      path: '/Large',
      mesh: sphere(0.4, { segments: 192, rings: 130 }),
      motion: restingAt([-1.4, -0.2, -4]),
    }),
  ],
};

/** Another scene, to put in the place of the first. */
export const OTHER: Scene = makeScene({
  name: 'other',
  objects: [makeObject({ path: '/Crate', mesh: box([1, 1, 1]), motion: restingAt([0, 0, -4]) })],
});

/** A picture to draw. */
interface Shot {
  readonly size: PictureSize;
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  readonly sampling: Sampling;
}

const BASE: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1 };

const eyeAt = (t: number, position: Vec3, beta: Vec3, turn = 0): ViewPoint => ({
  t,
  position,
  u: properVelocity(beta),
  orientation: fromAxisAngle([0, 1, 0], turn),
  lens: perspective(1),
});

const WIDE = { width: 64, height: 48 };
const HIGH = { width: 36, height: 52 };
const SMALL = { width: 40, height: 24 };

/** Pictures of the first renderer, in a row: of temporal antialiasing the history counts. */
export const FIRST: readonly Shot[] = [
  { size: WIDE, view: eyeAt(4, [0, 0, 0], [0, 0, -0.4]), settings: BASE, sampling: 'temporal' },
  { size: WIDE, view: eyeAt(4.05, [0, 0, 0], [0, 0, -0.4]), settings: BASE, sampling: 'temporal' },
  { size: WIDE, view: eyeAt(12, [0.2, 0, 0], [0.3, 0, -0.3]), settings: BASE, sampling: 1 },
  { size: SMALL, view: eyeAt(6, [0, 0.2, 0.3], [0, 0, 0]), settings: { ...BASE, tone: 'agx' }, sampling: 1 },
];
/** Of the one beside it: another place, time, size, view, and without shadows. */
const SLICE: RenderSettings = { ...BASE, view: 'simultaneity', shadows: false, occlusionRadius: 0 };
export const BESIDE: readonly Shot[] = [
  { size: HIGH, view: eyeAt(1, [0.6, 0.4, 0.5], [0.2, 0, -0.2], 0.1), settings: SLICE, sampling: 1 },
  { size: HIGH, view: eyeAt(8, [-0.4, 0.4, 0.5], [0, 0, 0.5], -0.1), settings: BASE, sampling: 1 },
  { size: SMALL, view: eyeAt(8.1, [-0.4, 0.4, 0.5], [0, 0, 0.5], -0.1), settings: BASE, sampling: 'temporal' },
  { size: SMALL, view: eyeAt(0, [-0.4, 0.4, 0.5], [0.5, 0, 0], -0.1), settings: SLICE, sampling: 2 },
];

/** Plain arrays, so that they can leave a page. */
export interface Drawn {
  readonly pixels: number[];
  readonly depth: number[];
}

export async function draw(renderer: SceneRenderer, shot: Shot, nextFrame: () => void): Promise<Drawn> {
  renderer.setSize(shot.size.width, shot.size.height);
  await renderLoaded(renderer, [[shot.view], shot.settings, shot.sampling], nextFrame);
  const pixels = Array.from(await renderer.readPixels());
  return { pixels, depth: Array.from(await renderer.readAov('depth')) };
}

export async function drawAll(
  renderer: SceneRenderer,
  shots: readonly Shot[],
  nextFrame: () => void,
): Promise<Drawn[]> {
  const drawn: Drawn[] = [];
  for (const shot of shots) drawn.push(await draw(renderer, shot, nextFrame));
  return drawn;
}

/** The pictures of both, one of each after the other. */
export async function drawInTurns(
  first: SceneRenderer,
  second: SceneRenderer,
  nextFrame: () => void,
): Promise<{ readonly first: Drawn[]; readonly beside: Drawn[] }> {
  const drawn = { first: [] as Drawn[], beside: [] as Drawn[] };
  for (const [i, shot] of FIRST.entries()) {
    drawn.first.push(await draw(first, shot, nextFrame));
    drawn.beside.push(await draw(second, BESIDE[i]!, nextFrame));
  }
  return drawn;
}
