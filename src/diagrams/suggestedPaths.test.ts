import { describe, expect, it } from 'vitest';
import { scene as twins } from '../../examples/scenes/twins.ts';
import type { Vec3 } from '../math/vec3.ts';
import { IDENTITY_POSE, makeObject, makeScene, restingAt } from '../scene/defaults.ts';
import { box } from '../scene/mesh/primitives.ts';
import type { SceneObject } from '../scene/types.ts';
import { suggestedPaths } from './suggestedPaths.ts';

const flying = (path: string, position: Vec3, velocity: Vec3, size: number): SceneObject =>
  makeObject({
    path,
    mesh: box([size, size, size]),
    motion: { kind: 'uniform', pose: { ...IDENTITY_POSE, position }, velocity },
  });
const suggested = (objects: readonly SceneObject[], limit = 9): readonly string[] =>
  suggestedPaths(makeScene({ name: 'scene', objects, startTime: 0, endTime: 5 }), limit, 10);

describe('things that are suggested', () => {
  it('are the first that move, or the first of all', () => {
    const still = makeObject({ path: '/Still', mesh: box([1, 1, 1]), motion: restingAt([0, 0, 0]) });
    const cars = ['/A', '/B', '/C'].map((path, i) => flying(path, [20 * i, 0, 0], [5, 0, 0], 2));
    expect(suggested([still, ...cars], 2)).toEqual(['/A', '/B']);
    expect(suggested([still, { ...still, path: '/Other' }], 1)).toEqual(['/Still']);
    const pieces = cars.map((car) => ({ ...car, pieceOf: '/Car' }));
    expect(suggested(pieces)).toEqual(['/Car']);
  });

  it('are not what another carries: small, near, and at one offset', () => {
    const cart = flying('/Cart', [0, 0, 0], [5, 0, 0], 4);
    const others = {
      '/Wheel': flying('/Wheel', [0, -3, 0], [5, 0, 0], 1),
      '/Wagon': flying('/Wagon', [5, 0, 0], [5, 0, 0], 4),
      '/Far': flying('/Far', [40, 0, 0], [5, 0, 0], 1),
      '/Faster': flying('/Faster', [0, -3, 0], [6, 0, 0], 1),
    };
    const all = Object.values(others);
    expect(suggested([cart, ...all])).toEqual(['/Cart', '/Wagon', '/Far', '/Faster']);
    expect(suggested([...all, cart])).toEqual(['/Wagon', '/Far', '/Faster', '/Cart']);
  });

  it('of the example of twins are the two dials', async () => {
    expect(suggestedPaths(await twins.make(), 4, 10)).toEqual(['/World/Home', '/World/Traveller']);
  });
});
