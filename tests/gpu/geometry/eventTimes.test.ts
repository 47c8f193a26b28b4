import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY } from '../../../src/math/quat.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { DEFAULT_LIGHT } from '../../../src/reference/lights/lightOptions.ts';
import { renderTile } from '../../../src/reference/tile.ts';
import { makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { plane } from '../../../src/scene/mesh/primitives.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { DATA_SETTINGS } from '../support/dataSettings.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const [SIZE, C] = [9, 10];
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

/** A wall that at t = 2 s is 8 m ahead and comes at 0.5 c; the observer flies towards it at 0.6 c. */
const SCENE = makeScene({
  name: 'wall',
  objects: [
    makeObject({
      path: '/wall',
      mesh: plane(80, 80),
      motion: { kind: 'uniform', velocity: [0, 0, 5], pose: { position: [0, 0, -18], orientation: IDENTITY } },
    }),
  ],
});
const VIEW: ViewPoint = { t: 2, position: [0, 0, 0], u: [0, 0, -0.75], orientation: IDENTITY, lens: perspective(0.1) };
/** c Δt = β·d/(1 − β·v) = 0.6 · 8/(1 + 0.6 · 0.5) m. */
const EXACT = 4.8 / 1.3 / C;

it.each([
  ['exact', 1, 0.3, EXACT],
  ['newton', 1, 0.3, 0.3 * EXACT],
  ['newton', 3, 0.3, (1 - 0.7 ** 3) * EXACT],
  ['newton', 1, 1, EXACT],
] as const)('in simultaneity the solver %s takes %s steps of %s', async (solver, iterations, damping, ahead) => {
  const settings: RenderSettings = {
    ...DATA_SETTINGS,
    view: 'simultaneity',
    speedOfLight: C,
    solver,
    iterations,
    damping,
  };
  await headless.renderer.setScene(SCENE);
  pumpFrame();
  headless.renderer.render([VIEW], settings, 1);
  const at = (SIZE * SIZE - 1) / 2;
  const time = (await headless.renderer.readAov('emission_time'))[at];
  const z = (await headless.renderer.readAov('position'))[3 * at + 2];
  expect(time - 2).toBeCloseTo(ahead, 5);
  expect(z).toBeCloseTo(-8 + 5 * ahead, 4);
});

it('10⁷ s after the world’s zero, times relative to the observer’s keep their digits in both renderers', async () => {
  const wall = makeObject({ path: '/wall', mesh: plane(80, 80), motion: restingAt([0, 0, -8]) });
  const scene = makeScene({ name: 'late', objects: [wall] });
  const view: ViewPoint = { ...VIEW, t: 1e7, u: [0, 0, 0] };
  const settings: RenderSettings = { ...DATA_SETTINGS, speedOfLight: C };
  await headless.renderer.setScene(scene);
  pumpFrame();
  headless.renderer.render([view], settings, 1);
  const drawn = await headless.renderer.readAov('emission_time_relative');
  const request = { view, settings, width: SIZE, height: SIZE, samples: 1, seed: 1, light: DEFAULT_LIGHT } as const;
  const traced = renderTile(
    createTracedScene(scene, C),
    { ...request, layers: ['emission_time_relative'] },
    { x0: 0, y0: 0, x1: SIZE, y1: SIZE },
  );
  const at = (SIZE * SIZE - 1) / 2;
  expect(drawn[at]).toBeCloseTo(-0.8, 6);
  expect(traced.emission_time_relative![at]).toBeCloseTo(-0.8, 6);
});
