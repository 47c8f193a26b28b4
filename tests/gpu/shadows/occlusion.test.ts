import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { openSceneFile } from '../../../src/cli/files/sceneFiles.ts';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { add, scale, sub, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { createTracedScene, type TracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { pixelSequence } from '../../../src/reference/sampling/pixelSequence.ts';
import { radiance } from '../../../src/reference/transport/path.ts';
import { restingAt } from '../../../src/scene/defaults.ts';
import { box, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { Mesh } from '../../../src/scene/types.ts';
import { lookAtOrientation, observerFromCamera } from '../../../src/scene/view/camera.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { dome, GREY, lambert, lit } from '../../support/lightKit.ts';
import { direction, uniform } from '../../support/physicsArbitraries.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import {
  type CornerMotion,
  cornerPicture,
  errorStatistics,
  FLIGHTS,
  floorOf,
  HEIGHT,
  profile,
  WIDTH,
} from './occlusionScenes.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(WIDTH, HEIGHT);
});
afterAll(() => headless?.close());

const floor = (flight: CornerMotion): Promise<[number, number][]> => {
  pumpFrame();
  return floorOf(headless.renderer, cornerPicture(flight));
};

describe('a wall hides (1 − cos α)/2 of the sky from the floor in front of it', () => {
  it.each(FLIGHTS)('%s', async (_, flight) => {
    const points = await floor(flight);
    expect(points.length).toBeGreaterThan(500);
    const { mean, most } = errorStatistics(points);
    if (process.env.REPORT) console.log(JSON.stringify(flight), mean, most, points.length);
    expect(mean).toBeLessThan(0.05);
    expect(most).toBeLessThan(0.1);
  });

  it('occlusion of a point does not depend on the velocities', async () => {
    const rest = await floor({ body: ZERO, observer: ZERO });
    const flying = fc.tuple(direction, uniform(0, 0.95)).map(([n, v]): Vec3 => scale(n, v));
    await fc.assert(
      fc.asyncProperty(flying, flying, async (body, observer) => {
        const points = await floor({ body, observer });
        fc.pre(points.length > 500);
        const [here, resting] = [profile(points), profile(rest)];
        here.forEach((open, k) => {
          // Each value is a mean over points with few rays: over 56 pairs of motions at most 0.04, and 0.03 in all but one.
          expect(Math.abs(open - resting[k])).toBeLessThan(0.045);
        });
      }),
      { numRuns: 8, endOnFailure: true },
    );
  });
});

describe('unoccluded surfaces see the whole sky', () => {
  const shares = async (mesh: Mesh, settings: Partial<RenderSettings>): Promise<number[]> => {
    const view = looking([0, 1, 4], [0, 0, 0]);
    await headless.renderer.setScene(lit([{ mesh, material: lambert(0.5) }]).scene);
    pumpFrame();
    headless.renderer.render([view], { ...GREY, ...settings }, 1);
    const [open, object] = await Promise.all([
      headless.renderer.readAov('occlusion'),
      headless.renderer.readAov('object'),
    ]);
    return [...open].filter((_, i) => object[i] === 1);
  };

  it.each([
    ['a floor, to its horizon', plane(500, 500, 'Y')],
    ['a ball of few facets', sphere(1, { segments: 16 })],
  ])('%s', async (_, mesh) => {
    const open = await shares(mesh, { occlusionRadius: 100 });
    expect(open.reduce((a, b) => a + b, 0) / open.length).toBeGreaterThan(0.99);
    expect(Math.min(...open)).toBeGreaterThan(0.9);
  });

  it('and with radius 0 all surfaces', async () => {
    const corner = cornerPicture({ body: ZERO, observer: ZERO });
    const points = await floorOf(headless.renderer, { ...corner, settings: { ...GREY, occlusionRadius: 0 } });
    expect(points.every(([, open]) => open === 1)).toBe(true);
  });
});

it('occlusion is deterministic, to the last bit', async () => {
  const flight = { body: ZERO, observer: [0, 0, -0.5] } as const;
  expect(await floor(flight)).toEqual(await floor(flight));
});

/** From `position`, at rest. */
const looking = (position: Vec3, target: Vec3): ViewPoint => ({
  t: 0,
  position,
  u: ZERO,
  orientation: lookAtOrientation(sub(target, position), [0, 1, 0]),
  lens: perspective(0.9),
});

interface Lit {
  readonly scene: TracedScene;
  readonly view: ViewPoint;
}

const SKY = dome([0.6, 0.7, 0.9]);
const boxAt = (size: Vec3, position: Vec3) => ({
  mesh: box(size),
  material: lambert(0.6),
  motion: restingAt(position),
});
const ground = { mesh: plane(40, 40, 'Y'), material: lambert(0.5) };

async function example(name: string, t?: number): Promise<Lit> {
  const scene = await openSceneFile(`examples/${name}.usdc`, {});
  const c = scene.hints.speedOfLight ?? 1;
  const time = t ?? scene.startTime;
  const view = { ...observerFromCamera(scene.cameras[0]!, time, c), t: time, u: ZERO };
  return { scene: createTracedScene({ ...scene, lights: [SKY] }, c), view };
}

/** A box on a plane, an arcade around a yard, and examples, with the upper bound of the remaining error. */
const SKYLIT: readonly (readonly [string, () => Lit | Promise<Lit>, number])[] = [
  [
    'a box on a plane',
    () => ({ scene: lit([ground, boxAt([2, 2, 2], [0, 1, 0])], [SKY]), view: looking([3, 3, 5], [0, 0.5, 0]) }),
    0.8,
  ],
  [
    'a courtyard',
    () => ({
      scene: lit(
        [
          ground,
          boxAt([12, 5, 0.5], [0, 2.5, -6]),
          boxAt([0.5, 5, 12], [-6, 2.5, 0]),
          boxAt([0.5, 5, 12], [6, 2.5, 0]),
          boxAt([12, 0.4, 2.5], [0, 3.5, -4.6]),
          ...[-4, -2, 0, 2, 4].map((x) => boxAt([0.4, 3.3, 0.4], [x, 1.65, -3.6])),
        ],
        [SKY],
      ),
      view: looking([-3, 2.4, 5.5], [0.5, 1.3, -2]),
    }),
    0.7,
  ],
  ['the street', () => example('street', 6.5), 0.8],
  ['the dice', () => example('dice'), 0.8],
];

/** Light of the rasterizer and of the reference in every sixth pixel of every sixth row. */
const [STEP, SAMPLES] = [6, 16];
const SMALL = { width: 96, height: 60 };

async function drawn({ scene, view }: Lit, settings: RenderSettings): Promise<Float32Array> {
  await headless.renderer.setScene({ ...scene.scene });
  pumpFrame();
  headless.renderer.render([view], settings, 1);
  return headless.renderer.readAov('beauty');
}

function* traced({ scene, view }: Lit, settings: RenderSettings): Generator<readonly [pixel: number, light: Vec3]> {
  const options = { bounces: 2, mirrors: true, glass: false };
  for (let y = STEP / 2; y < SMALL.height; y += STEP)
    for (let x = STEP / 2; x < SMALL.width; x += STEP) {
      const ray = cameraRay(view, settings, x + 0.5, y + 0.5, SMALL.width, SMALL.height)!;
      const numbers = pixelSequence(1, x, y);
      let sum = ZERO;
      for (let i = 0; i < SAMPLES; i++) sum = add(sum, radiance(scene, ray, view, settings, options, numbers(i)));
      yield [y * SMALL.width + x, scale(sum, 1 / SAMPLES)];
    }
}

describe('occlusion brings pictures under sky light closer to the reference', () => {
  beforeAll(() => headless.renderer.setSize(SMALL.width, SMALL.height));
  afterAll(() => headless.renderer.setSize(WIDTH, HEIGHT));
  it.each(SKYLIT)('%s', async (name, make, bound) => {
    const given = await make();
    const settings = { ...GREY, beaming: 0, speedOfLight: given.scene.c };
    const open = await drawn(given, { ...settings, occlusionRadius: 0 });
    const hidden = await drawn(given, settings);
    let [without, within] = [0, 0];
    for (const [pixel, light] of traced(given, settings))
      light.forEach((value, k) => {
        without += Math.abs(open[3 * pixel + k] - value);
        within += Math.abs(hidden[3 * pixel + k] - value);
      });
    if (process.env.REPORT) console.log(`${name}: ${within / without} of the error is left`);
    expect(within).toBeLessThan(bound * without);
  });
});

describe('on WebGL2', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./occlusionPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());
  it.each([FLIGHTS[0], FLIGHTS[4]])('%s', async (_, flight) => {
    const points = await chromium.page.evaluate((given) => window.floorOf(given), flight);
    chromium.assertHealthy();
    expect(points.length).toBeGreaterThan(500);
    expect(errorStatistics(points).mean).toBeLessThan(0.05);
  });
});
