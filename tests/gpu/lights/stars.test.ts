import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { fromAxisAngle } from '../../../src/math/quat.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { DEFAULT_LIGHT } from '../../../src/reference/lights/lightOptions.ts';
import { renderTile } from '../../../src/reference/tile.ts';

import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { withMaterial } from '../../../src/scene/mesh/meshOps.ts';
import { sphere } from '../../../src/scene/mesh/primitives.ts';
import { brightStars } from '../../../src/scene/stars/brightStars.ts';
import { EQUATORIAL } from '../../../src/scene/stars/equatorial.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type ViewPoint } from '../../../src/scene/view/view.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const [WIDTH, HEIGHT] = [160, 120];
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(WIDTH, HEIGHT);
});
afterAll(() => headless?.close());

/** Orion behind a dark ball, and behind a half-transparent one. */
const scene: Scene = makeScene({
  name: 'stars',
  objects: [
    makeObject({ path: '/Ball', mesh: sphere(1.2, { segments: 48, rings: 24 }), motion: restingAt([-10, 0, 0]) }),
    makeObject({
      path: '/Veil',
      mesh: withMaterial(sphere(1.2, { segments: 48, rings: 24 }), 1),
      motion: restingAt([-10, 1.5, 2]),
    }),
  ],
  materials: [
    makeMaterial({ name: 'black', baseColor: [0, 0, 0], roughness: 1 }),
    makeMaterial({ name: 'veil', baseColor: [0, 0, 0], roughness: 1, opacity: 0.5 }),
  ],
  lights: [{ kind: 'stars', path: '/Stars', stars: brightStars(), orientation: EQUATORIAL, gain: 1 }],
});

describe('the stars', () => {
  it.each([
    { u: 0, fovY: 0.9 },
    { u: 2.06, fovY: 0.9 },
    // Fast enough for a visible cosmic background.
    { u: 700, fovY: 0.02 },
  ])('agree between rasterizer and reference, at γβ = $u', async ({ u, fovY }) => {
    const view: ViewPoint = {
      t: 0,
      position: [0, 0, 0],
      u: [-u, 0, 0],
      orientation: fromAxisAngle([0, 1, 0], fovY < 0.1 ? Math.PI / 2 : 1.44),
      lens: perspective(fovY),
    };
    await headless.renderer.setScene(scene);
    pumpFrame();
    headless.renderer.render([view], DEFAULT_SETTINGS, 1);
    const drawn = await headless.renderer.readAov('beauty');
    const request = { view, settings: DEFAULT_SETTINGS, width: WIDTH, height: HEIGHT, layers: ['beauty'] } as const;
    const tile = { x0: 0, y0: 0, x1: WIDTH, y1: HEIGHT };
    const traced = renderTile(
      createTracedScene(scene, DEFAULT_SETTINGS.speedOfLight),
      { ...request, samples: 1, seed: 1, light: DEFAULT_LIGHT },
      tile,
    );
    const expected = traced.beauty!;
    const most = Math.max(...expected);
    const errors = expected.map((value, i) => Math.abs(value - drawn[i]) / most);
    const wrong = errors.filter((value) => value > 1e-3).length / expected.length;
    expect(expected.filter((value) => value > 0.01 * most).length).toBeGreaterThan(100);
    // For stars at the edge of the ball the triangulation matters.
    expect(wrong).toBeLessThan(1e-3);
  });
});
