import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { add, normalize, scale, sub, type Vec3, ZERO } from '../../src/math/vec3.ts';
import { apparentPosition } from '../../src/physics/apparent.ts';
import { properVelocity } from '../../src/physics/boost.ts';
import { simultaneousPosition } from '../../src/physics/simultaneity.ts';
import { lookAtOrientation } from '../../src/scene/camera.ts';
import { probeVertices } from '../../src/scene/probe.ts';
import type { Scene } from '../../src/scene/types.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../src/scene/view.ts';
import { type ModulePage, openModulePage } from './browser.ts';
import { type HeadlessPictures, openPictures } from './pictures.ts';
import { angle, ReferencePicture } from './pixels.ts';
import { type Data, readData } from './readData.ts';
import { C, EYE, SCENES, T } from './renderScenes.ts';

const WIDTH = 160;
const HEIGHT = 90;
const STRIDE = 5;

const FORWARD = normalize([0.3, 0.1, -0.6]);
const OTHER_VIEWS: readonly [string, Partial<RenderSettings>][] = [
  ['without light delay', { lightDelay: false }],
  ['without aberration', { aberration: false }],
  ['simultaneity', { view: 'simultaneity' }],
  ['galilean', { view: 'galilean' }],
];

/** Looks where the first object's middle is in this view. */
function viewOf(scene: Scene, u: Vec3, settings: RenderSettings): ViewPoint {
  const observer = { t: T, position: EYE, u };
  const delayed = settings.lightDelay || settings.view !== 'light-cone';
  const view = delayed ? settings.view : 'galilean';
  const probes = probeVertices(scene.objects[0], observer, C, view).filter((p) => p !== undefined);
  const boosted = settings.aberration && settings.view === 'light-cone';
  const place = (x: Vec3) =>
    settings.view === 'simultaneity' ? simultaneousPosition(x, u) : boosted ? apparentPosition(x, u) : x;
  const places = probes.map((p) => place(sub(p.position, EYE)));
  const middle = scale(places.reduce(add, ZERO), 1 / places.length);
  // It fills most of the picture, however small or large the speed makes it.
  const fovY = Math.min(1.5, 3 * Math.max(...places.map((x) => angle(x, middle))));
  return { t: T, position: EYE, u, orientation: lookAtOrientation(middle, [0, 1, 0]), fovY };
}

/** Errors of the pixels that were compared, and how many are of another object than they should. */
interface Errors {
  readonly pixels: number[];
  readonly time: number[];
  readonly depth: number[];
  readonly doppler: number[];
  readonly velocity: number[];
  wrongObject: number;
}

/** Renders a scene and reads the data of every pixel. */
type Paint = (scene: Scene, view: ViewPoint, settings: RenderSettings) => Promise<Data>;

function pixelsOf(data: Data) {
  const vector = (of: ArrayLike<number>, i: number): Vec3 => [of[3 * i], of[3 * i + 1], of[3 * i + 2]];
  return (x: number, y: number) => {
    const i = y * WIDTH + x;
    return {
      object: data.object[i],
      position: vector(data.position, i),
      time: data.emission_time[i],
      doppler: data.doppler[i],
      velocity: vector(data.velocity, i),
      depth: data.depth[i],
    };
  };
}

async function compare(paint: Paint, scene: Scene, u: Vec3, settings: RenderSettings): Promise<Errors> {
  const view = viewOf(scene, u, settings);
  const reference = new ReferencePicture(scene, view, settings);
  const seen = pixelsOf(await paint(scene, view, settings));
  const errors: Errors = { pixels: [], time: [], depth: [], doppler: [], velocity: [], wrongObject: 0 };
  const pixel = (2 * Math.tan(view.fovY / 2)) / HEIGHT;
  for (let y = 2; y < HEIGHT; y += STRIDE) {
    for (let x = 2; x < WIDTH; x += STRIDE) {
      const at = (dx: number, dy: number) => reference.at(x + 0.5 + dx, y + 0.5 + dy, WIDTH, HEIGHT);
      const is = seen(x, y);
      const should = at(0, 0);
      if (is.object !== (should?.object ?? 0)) {
        // On an outline, a tenth of a pixel may decide.
        const near = [at(0.1, 0), at(-0.1, 0), at(0, 0.1), at(0, -0.1)].map((p) => p?.object ?? 0);
        if (!near.includes(is.object)) errors.wrongObject++;
      } else if (!should) {
        if (is.doppler !== 0 || is.time !== 0 || is.depth !== 0) errors.wrongObject++;
      } else {
        const dx = sub(is.position, EYE);
        errors.pixels.push(angle(apparentPosition(dx, u), apparentPosition(should.dx, u)) / pixel);
        errors.time.push(Math.abs(is.time - T - should.delay));
        errors.depth.push(Math.abs(is.depth / should.depth - 1));
        errors.doppler.push(Math.abs(is.doppler / should.doppler - 1));
        errors.velocity.push(Math.hypot(...sub(is.velocity, should.velocity)));
      }
    }
  }
  return errors;
}

const CASES = SCENES.flatMap((scene) => [
  ...[0, 0.9, 0.9999].map((beta) => ({ scene, view: 'light-cone', change: {}, beta })),
  ...OTHER_VIEWS.map(([view, change]) => ({ scene, view, change, beta: 0.6 })),
]);
const named = (cases: typeof CASES) =>
  cases.map((given) => [`${given.scene.name}, ${given.view}, ${given.beta} c`, given] as const);
const worst = (values: readonly number[]) => Math.max(0, ...values);
/** Near an outline the rasterizer's own grid decides (1/16 pixel on SwiftShader), so most pixels must be better than the worst. */
const most = (values: readonly number[]) =>
  [...values].sort((a, b) => a - b)[Math.floor(0.9 * (values.length - 1))] ?? 0;

async function expectRight(paint: Paint, { scene, view, change, beta }: (typeof CASES)[number]): Promise<void> {
  const settings = { ...DEFAULT_SETTINGS, ...change, speedOfLight: C };
  const errors = await compare(paint, scene, properVelocity(scale(FORWARD, beta)), settings);
  if (process.env.SHOW_ERRORS) console.log('#', scene.name, view, beta, summary(errors));
  expect(errors.wrongObject).toBe(0);
  expect(errors.pixels.length).toBeGreaterThan(scene.name === 'lifetimes' && view === 'simultaneity' ? -1 : 40);
  expect(worst(errors.pixels)).toBeLessThan(0.1);
  expect(most(errors.depth)).toBeLessThan(1e-3);
  expect(worst(errors.depth)).toBeLessThan(2e-2);
  expect(most(errors.doppler)).toBeLessThan(2e-4);
  expect(worst(errors.doppler)).toBeLessThan(5e-3);
  // f32 holds 1e4 s to half a millisecond.
  expect(most(errors.time)).toBeLessThan(1e-3);
  expect(worst(errors.time)).toBeLessThan(2e-2);
  expect(most(errors.velocity)).toBeLessThan(5e-4);
  // From one piece of a sampled path to the next the velocity jumps, and at an outline the grid decides which is seen.
  expect(worst(errors.velocity)).toBeLessThan(2e-2);
}

describe('every pixel against the f64 library, at t = 1e4 s and c = 10 m/s: WebGPU (Dawn)', () => {
  let headless: HeadlessPictures;
  beforeAll(async () => {
    headless = await openPictures(WIDTH, HEIGHT);
  });
  afterAll(() => headless?.close());

  it.each(named(CASES))('%s', async (_, given) => {
    await expectRight(async (scene, view, settings) => {
      await headless.renderer.setScene(scene);
      return readData(headless.renderer, view, settings);
    }, given);
  });
});

describe('the same on WebGL2 (Chromium)', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('renderPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());

  const some = CASES.filter(({ view, beta }) => beta === 0.9 || view === 'simultaneity');
  it.each(named(some))('%s', async (_, given) => {
    const paint: Paint = async (scene, view, settings) => {
      const data = await chromium.page.evaluate(
        ([name, at, how, width, height]) => window.renderScene(name, at, how, width, height),
        [scene.name, view, settings, WIDTH, HEIGHT] as const,
      );
      chromium.assertHealthy();
      return data;
    };
    await expectRight(paint, given);
  });
});

const summary = ({ wrongObject, ...all }: Errors): string =>
  Object.entries(all)
    .map(([name, v]) => `${name} ${most(v).toExponential(1)}/${worst(v).toExponential(1)}`)
    .join(' ');
