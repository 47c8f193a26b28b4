import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import { normalize } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import type { PickResult, Sampling } from '../../../src/render/settings.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { withMaterial } from '../../../src/scene/mesh/meshOps.ts';
import { box, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import { brightStars } from '../../../src/scene/stars/brightStars.ts';
import { EQUATORIAL } from '../../../src/scene/stars/equatorial.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { offAxisLens } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { PictureView, PictureViews, PixelRect } from '../../../src/scene/view/pictureViews.ts';
import { type AovName, DEFAULT_SETTINGS, type RenderSettings } from '../../../src/scene/view/view.ts';
import { renderLoaded } from '../../support/renderLoaded.ts';

/** With all that depends on the observer: things that move, shadows of the sun and of a lamp, stars, and what light shines through. */
export const SCENE: Scene = makeScene({
  name: 'views',
  objects: [
    makeObject({ path: '/Floor', mesh: plane(20, 20, 'Y'), motion: restingAt([0, -1, -5]) }),
    makeObject({ path: '/Crate', mesh: box([1, 1, 1]), motion: restingAt([-1.6, -0.5, -4]) }),
    makeObject({
      path: '/Ball',
      mesh: sphere(0.8),
      motion: { kind: 'uniform', pose: { position: [1, 0, -4], orientation: IDENTITY }, velocity: [0.5, 0, 0] },
    }),
    makeObject({ path: '/Veil', mesh: withMaterial(sphere(0.7), 1), motion: restingAt([1.2, 0.2, -3]) }),
  ],
  materials: [
    makeMaterial({ name: 'matt', baseColor: [0.7, 0.6, 0.5], roughness: 0.8 }),
    makeMaterial({ name: 'veil', baseColor: [0.2, 0.4, 0.8], opacity: 0.5 }),
  ],
  lights: [
    { kind: 'stars', path: '/Stars', stars: brightStars(), orientation: EQUATORIAL, gain: 3e4 },
    { kind: 'distant', path: '/Sun', direction: normalize([0.4, -1, -0.3]), color: [2, 1.9, 1.7] },
  ],
});

/** Two eyes, each with an event, a velocity, an orientation, an off-axis frustum and a size of its own, in a picture that they do not fill. */
export const SIZE = { width: 112, height: 44 };
const LEFT: PixelRect = { x: 2, y: 1, width: 48, height: 40 };
const RIGHT: PixelRect = { x: 57, y: 4, width: 52, height: 36 };
export const EYES = [
  {
    t: 0.1,
    position: [-0.3, 0.1, 0],
    u: properVelocity([0.1, 0, -0.5]),
    orientation: fromAxisAngle([0, 1, 0], 0.1),
    lens: offAxisLens({ left: -0.5, right: 0.7, bottom: -0.6, top: 0.4 }),
    viewport: LEFT,
  },
  {
    t: 0.3,
    position: [0.3, 0, 0.2],
    u: properVelocity([0, 0.1, -0.3]),
    orientation: fromAxisAngle([0, 1, 0], -0.1),
    lens: offAxisLens({ left: -0.8, right: 0.5, bottom: -0.45, top: 0.45 }),
    viewport: RIGHT,
  },
] as const satisfies PictureViews;

const alone = ({ viewport: _, ...view }: PictureView): PictureViews => [view];

export const LIGHT: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1, grid: true };
/** How pictures are made: settings and sampling of each, and how many one after another. */
export const CASES: Readonly<Record<string, { settings: RenderSettings; sampling: Sampling; frames?: number }>> = {
  'with FXAA': { settings: LIGHT, sampling: 1 },
  'with 2 × 2 samples': { settings: LIGHT, sampling: 2 },
  // As many as there are sample positions, so that the next sequence begins with the same one; shadows are in the others.
  'in a sequence, with temporal antialiasing': {
    settings: { ...LIGHT, shadows: false, occlusionRadius: 0 },
    sampling: 'temporal',
    frames: 16,
  },
  'in false colours': {
    settings: { ...LIGHT, falseColors: { kind: 'doppler', from: 0.4, to: 2.5 } },
    sampling: 2,
  },
  'with effects': {
    settings: {
      ...LIGHT,
      frameGraph: {
        extraBuffers: [],
        passes: [
          { kind: 'light', buffer: 0, shadows: true, occlusion: true },
          { kind: 'effect', effect: 'vignette', args: [1, 4, 0], image: 0, buffer: 0 },
          { kind: 'effect', effect: 'depth-of-field', args: [4, 30, 6], image: 1, buffer: 0 },
        ],
      },
    },
    sampling: 1,
  },
};

/** Plain arrays, so that they can leave a page. */
export interface RenderedViews {
  readonly pixels: number[];
  readonly depth: number[];
  readonly beauty: number[];
}

const AOVS: readonly AovName[] = ['depth', 'beauty'];

async function rendered(
  renderer: SceneRenderer,
  views: (frame: number) => PictureViews,
  { settings, sampling, frames = 1 }: (typeof CASES)[string],
  nextFrame: () => void,
): Promise<RenderedViews> {
  for (let frame = 0; frame < frames; frame++) {
    await renderLoaded(renderer, [views(frame), settings, sampling], nextFrame);
  }
  const pixels = Array.from(await renderer.readPixels());
  const [depth, beauty] = [[], []] as number[][];
  for (const name of AOVS) (name === 'depth' ? depth : beauty).push(...(await renderer.readAov(name)));
  return { pixels, depth, beauty };
}

const moved = (view: PictureView, frame: number): PictureView => ({ ...view, t: view.t + 0.02 * frame });

/** Both eyes in one picture, and each in a picture of its own. */
export async function renderTogetherAndAlone(
  renderer: SceneRenderer,
  name: string,
  nextFrame: () => void,
): Promise<{ readonly together: RenderedViews; readonly alone: readonly RenderedViews[] }> {
  const made = CASES[name];
  renderer.setSize(SIZE.width, SIZE.height);
  const both = (frame: number): PictureViews => [moved(EYES[0], frame), moved(EYES[1], frame)];
  const together = await rendered(renderer, both, made, nextFrame);
  const each: RenderedViews[] = [];
  for (const eye of EYES) {
    // A history begins anew with a scene.
    if (made.sampling === 'temporal') await renderer.setScene({ ...SCENE });
    renderer.setSize(eye.viewport.width, eye.viewport.height);
    each.push(await rendered(renderer, (frame) => alone(moved(eye, frame)), made, nextFrame));
  }
  return { together, alone: each };
}

/** A still picture of both that has gained n × n samples, and those alone that have. */
export async function accumulateTogetherAndAlone(
  renderer: SceneRenderer,
  n: number,
  nextFrame: () => void,
): Promise<{ readonly together: number[]; readonly alone: readonly number[][] }> {
  const accumulated = async (views: PictureViews, width: number, height: number): Promise<number[]> => {
    renderer.setSize(width, height);
    nextFrame();
    renderer.render(views, LIGHT, 1);
    do nextFrame();
    while (renderer.accumulate(n));
    return Array.from(await renderer.readPixels());
  };
  const together = await accumulated(EYES, SIZE.width, SIZE.height);
  const each: number[][] = [];
  for (const eye of EYES) each.push(await accumulated(alone(eye), eye.viewport.width, eye.viewport.height));
  return { together, alone: each };
}

/** A sub-rectangle of a symmetric picture, and the same part through a lens of its own. */
export const CROP: PixelRect = { x: 10, y: 4, width: 50, height: 30 };

export async function renderWholeAndCrop(renderer: SceneRenderer, nextFrame: () => void) {
  const [eye] = EYES;
  const { width, height } = SIZE;
  const tanY = 0.6;
  const tanX = (tanY * width) / height;
  const lens = offAxisLens({ left: -tanX, right: tanX, bottom: -tanY, top: tanY });
  const crop = offAxisLens({
    left: tanX * ((2 * CROP.x) / width - 1),
    right: tanX * ((2 * (CROP.x + CROP.width)) / width - 1),
    bottom: tanY * (1 - (2 * (CROP.y + CROP.height)) / height),
    top: tanY * (1 - (2 * CROP.y) / height),
  });
  const settings = { ...LIGHT, antialiasing: false, grid: true, occlusionRadius: 0 };
  const read = async (views: PictureViews, size: { width: number; height: number }) => {
    renderer.setSize(size.width, size.height);
    nextFrame();
    renderer.render(views, settings, 1);
    const [object, doppler] = [await renderer.readAov('object'), await renderer.readAov('doppler')];
    const pixels = await renderer.readPixels();
    return { object: Array.from(object), doppler: Array.from(doppler), pixels: Array.from(pixels) };
  };
  const { viewport: _, ...view } = eye;
  return { whole: await read([{ ...view, lens }], SIZE), crop: await read([{ ...view, lens: crop }], CROP) };
}

/** Pixels spread over both eyes, with their corners. */
const PICKED: readonly (readonly [number, number])[] = [LEFT, RIGHT].flatMap(({ x, y, width, height }) =>
  [0, 0.2, 0.4, 0.6, 0.8, 1].flatMap((across) =>
    [0, 0.4, 0.6, 1].map(
      (down) => [x + Math.floor(across * (width - 1)), y + Math.floor(down * (height - 1))] as const,
    ),
  ),
);

/** Channels of the picture that a picked pixel has too. */
const PICKED_AOVS = ['object', 'emission_time', 'position', 'velocity', 'doppler', 'depth', 'beauty'] as const;

/** What is picked in both eyes, and the same pixels of whole channels. `sampling`: of the picture before. */
export async function pickBoth(
  renderer: SceneRenderer,
  sampling: Sampling,
  nextFrame: () => void,
): Promise<{ readonly picked: (PickResult | undefined)[]; readonly channels: Record<string, number[]>[] }> {
  renderer.setSize(SIZE.width, SIZE.height);
  nextFrame();
  renderer.render(EYES, LIGHT, sampling);
  const picked: (PickResult | undefined)[] = [];
  for (const [x, y] of PICKED) picked.push(await renderer.pick(x, y));
  const channels: Record<string, number[]>[] = PICKED.map(() => ({}));
  for (const name of PICKED_AOVS) {
    const values = await renderer.readAov(name);
    const size = values.length / (SIZE.width * SIZE.height);
    for (const [i, [x, y]] of PICKED.entries()) {
      const at = size * (y * SIZE.width + x);
      channels[i]![name] = Array.from(values.subarray(at, at + size));
    }
  }
  return { picked, channels };
}
