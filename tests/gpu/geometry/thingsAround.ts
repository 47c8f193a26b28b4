import { fromAxisAngle, IDENTITY, multiply } from '../../../src/math/quat.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { box, grid, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { Lens } from '../../../src/scene/view/lenses/lenses.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';

export const C = 10;
export const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: C, antialiasing: false };

export type BoxAround = readonly [path: string, position: Vec3, size: number];

/** Ahead, behind and on the floor the same; others as given; and a ball in flight. */
export const thingsAround = (others: readonly BoxAround[]) => {
  const boxes: readonly BoxAround[] = [['/Ahead', [1, 0, -8], 2], ['/Behind', [-1, 1, 7], 2], ...others];
  return makeScene({
    name: 'around',
    materials: [makeMaterial({ name: 'matte', baseColor: [0.6, 0.5, 0.4], ior: 1, roughness: 1 })],
    objects: [
      makeObject({ path: '/Floor', mesh: grid(40, 40, 8, 8, 'Y'), motion: restingAt([0, -2, 0]) }),
      ...boxes.map(([path, position, size]) =>
        makeObject({ path, mesh: box([size, size, size]), motion: restingAt(position) }),
      ),
      makeObject({
        path: '/Ball',
        mesh: sphere(1.5, { segments: 64, rings: 32 }),
        motion: { kind: 'uniform', pose: { position: [-6, 2, -5], orientation: IDENTITY }, velocity: [0.8 * C, 0, 0] },
      }),
    ],
  });
};

/** An observer among them, in flight and turned. */
export const eye = (lens: Lens): ViewPoint => ({
  t: 0.3,
  position: [0.3, 0.2, 0.5],
  u: properVelocity([0.5, 0.1, -0.6]),
  orientation: multiply(fromAxisAngle([0, 1, 0], 0.4), fromAxisAngle([1, 0, 0], 0.2)),
  lens,
});
