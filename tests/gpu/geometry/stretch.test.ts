import { afterAll, beforeAll, expect, it } from 'vitest';
import type { Mat3 } from '../../../src/math/mat3.ts';
import { fromAxisAngle } from '../../../src/math/quat.ts';
import { normalize, type Vec3 } from '../../../src/math/vec3.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import { withoutQuadric } from '../../../src/scene/mesh/quadric.ts';
import { bakedObject } from '../../../src/scene/mesh/stretch.ts';
import type { Light, Motion, Scene, SceneObject } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS } from '../../../src/scene/view/view.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = 160;
const C = 10;

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

const ball = withoutQuadric(sphere(0.5, { segments: 24, rings: 12 }));
const stretchOf = (i: number): Mat3 => [0.6 + 0.2 * (i % 4), 0.2 * (i % 3), 0, 0, 1.4 - 0.2 * (i % 5), 0, 0.2, 0, 0.8];

const row = (name: string, z: number, motionOf: (position: Vec3, i: number) => Motion): SceneObject[] =>
  Array.from({ length: 9 }, (_, i) =>
    makeObject({
      path: `/${name}${i}`,
      mesh: ball,
      stretch: stretchOf(i),
      motion: motionOf([1.3 * (i - 4), 0.9, z], i),
    }),
  );
const oriented = (position: Vec3, i: number) => ({ position, orientation: fromAxisAngle(normalize([1, i, 2]), i) });

const sun: Light = { kind: 'distant', path: '/Sun', direction: normalize([0.4, -1, -0.3]), color: [3, 3, 3] };
const scene: Scene = makeScene({
  name: 'stretched bodies',
  objects: [
    ...row('Resting', -6, (position, i) => ({ kind: 'static', pose: oriented(position, i) })),
    ...row('Flying', -8, (position, i) => ({ kind: 'uniform', pose: oriented(position, i), velocity: [5, 0, 0] })),
    makeObject({ path: '/Floor', mesh: plane(40, 40, 'Y'), motion: restingAt([0, 0, -8]) }),
  ],
  materials: [makeMaterial({ name: 'grey', baseColor: [0.6, 0.5, 0.4] })],
  lights: [sun],
});

it.each([0, 0.8])(
  'shaded pictures, with shadows, are those of objects with meshes of their own, at %s c',
  async (beta) => {
    const { renderer } = headless;
    const view = {
      t: 0,
      position: [0, 2.5, 0] as const,
      u: [0, 0, -beta / Math.sqrt(1 - beta * beta)] as const,
      orientation: fromAxisAngle([1, 0, 0], -0.25),
      lens: perspective(1.1),
    };
    const picture = async (objects: readonly SceneObject[]) => {
      await renderer.setScene({ ...scene, objects });
      renderer.render([view], { ...DEFAULT_SETTINGS, speedOfLight: C });
      return { pixels: await renderer.readPixels(), ids: await renderer.readAov('object') };
    };
    const shared = await picture(scene.objects);
    const baked = await picture(scene.objects.map(bakedObject));
    // At outlines and edges of shadows a pixel may fall on the other side.
    const differs = (a: ArrayLike<number>, b: ArrayLike<number>, most: number): number =>
      Array.from(a).filter((x, i) => Math.abs(x - b[i]) > most).length / a.length;
    expect(differs(shared.ids, baked.ids, 0)).toBeLessThan(2e-3);
    expect(differs(shared.pixels, baked.pixels, 4)).toBeLessThan(4e-3);
    expect(new Set(Array.from(baked.ids)).size).toBeGreaterThan(10);
  },
);
