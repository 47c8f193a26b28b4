import { expect, it } from 'vitest';
import { makeObject, makeScene, restingAt } from '../../scene/defaults.ts';
import { box } from '../../scene/mesh/primitives.ts';
import { loadedScene } from './loadedScene.ts';

const mesh = box([1, 1, 1]);
const moving = (path: string, speed: number) =>
  makeObject({
    path,
    mesh,
    motion: { ...restingAt([0, 0, 0]), kind: 'uniform', velocity: [speed, 0, 0] },
  });

it('finds the fastest point, and none in a static scene', () => {
  const scene = makeScene({ name: 'a', objects: [moving('/slow', 2), moving('/fast', 7), moving('/still', 0)] });
  expect(loadedScene(scene).fastest).toEqual({ path: '/fast', time: 0, speed: 7 });
  expect(loadedScene(makeScene({ name: 'b', objects: [makeObject({ path: '/a', mesh })] })).fastest).toBeUndefined();
});

it('skips objects that cannot be drawn, and reports them', () => {
  const broken = { ...mesh, positions: mesh.positions.map((x, i) => (i === 0 ? Number.NaN : x)) };
  const objects = [makeObject({ path: '/bad', mesh: broken }), makeObject({ path: '/good', mesh })];
  const { scene } = loadedScene(makeScene({ name: 'c', objects }));
  expect(scene.objects.map(({ path }) => path)).toEqual(['/good']);
  expect(scene.diagnostics).toMatchObject([{ severity: 'warning', code: 'mesh.not-finite', place: '/bad' }]);
});
