import { expect, it } from 'vitest';
import { fromAxisAngle } from '../../math/quat.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../scene/defaults.ts';
import { box, sphere } from '../../scene/mesh/primitives.ts';
import { withoutQuadric } from '../../scene/mesh/quadric.ts';
import type { Material, Mesh, SceneObject } from '../../scene/types.ts';
import { makeBatches } from './batches.ts';
import { makeBody } from './bodies.ts';
import { ReleasedPieces } from './releasedPieces.ts';

const batchesOf = (objects: SceneObject[], materials: Material[] = []) => {
  const scene = makeScene({ name: 'test', objects, materials });
  return makeBatches(
    scene,
    objects.map((object, i) => makeBody(object, i + 1)),
  );
};

it('objects with one kind of motion share a batch, which has every triangle once', () => {
  const objects = Array.from({ length: 40 }, (_, i) =>
    makeObject({ path: `/${i}`, mesh: box([1, 1, 1]), motion: restingAt([i, 0, 0]) }),
  );
  const batches = batchesOf(objects);
  expect(batches).toHaveLength(1);
  expect(batches[0].arrays.indices).toHaveLength(40 * 36);
  expect(new Set(batches[0].arrays.ids.filter((_, i) => i % 2 === 0)).size).toBe(40);
});

it('vertices are relative to the centre of their object, and rotated with it', () => {
  const shifted = { ...box([2, 2, 2]), positions: box([2, 2, 2]).positions.map((x, i) => (i % 3 === 0 ? x + 1e6 : x)) };
  const pose = { position: [0, 0, 0] as const, orientation: fromAxisAngle([0, 0, 1], Math.PI / 4) };
  const [{ arrays }] = batchesOf([makeObject({ path: '/far', mesh: shifted, motion: { kind: 'static', pose } })]);
  expect(Math.max(...arrays.positions)).toBeCloseTo(Math.SQRT2, 6);
});

it('deforming, large and transparent objects get batches of their own', () => {
  const glass = makeMaterial({ name: 'glass', opacity: 0.5 });
  const mesh = sphere(1);
  const pane = { ...mesh, groups: mesh.groups.map((g) => ({ ...g, material: 1 })) };
  const large = sphere(1, { segments: 200, rings: 100 });
  const objects = [
    ...[pane, pane, mesh, mesh, large].map((m, i) => makeObject({ path: `/${i}`, mesh: m })),
    makeObject({
      path: '/cloth',
      mesh,
      motion: {
        kind: 'sampled-points',
        times: Float64Array.of(0, 1),
        origin: [0, 0, 0],
        points: [mesh.positions, mesh.positions],
      },
    }),
  ];
  const batches = batchesOf(objects, [makeMaterial({ name: 'matt' }), glass]);
  expect(batches.map((b) => b.bodies.map(({ id }) => id))).toEqual([[1], [2], [3, 4], [5], [6]]);
  expect(batches.map((b) => b.transparent)).toEqual([true, true, false, false, false]);
});

it('pieces with meshes of their own get batches of their own, several lives of one mesh do not', () => {
  const shared = box([1, 1, 1]);
  const piece = (whole: string, n: number, mesh: Mesh): SceneObject => ({
    ...makeObject({ path: `${whole}/piece${n}`, mesh, lifetime: { birth: n, death: n + 1 } }),
    pieceOf: whole,
  });
  const own = [1, 2].map((n) => piece('/Water', n, box([n, 1, 1])));
  const lives = [1, 2].map((n) => piece('/Lamp', n, shared));
  const batches = batchesOf([...own, ...lives]);
  expect(batches.map((b) => b.bodies.map(({ id }) => id))).toEqual([[1], [2], [3, 4]]);
});

it('pieces are released when 16 pictures have not shown them, and not again before they are seen', () => {
  const pieces = new ReleasedPieces(['a', 'b']);
  const released: string[][] = [];
  for (let i = 0; i < 40; i++) released.push([...pieces.next((piece) => piece === 'a' || i === 0)]);
  expect(released.flatMap((of, i) => of.map((piece) => [i, piece]))).toEqual([[16, 'b']]);
});

it('a mesh shared by many objects is stored once, with the object and the material of each', () => {
  const mesh = sphere(1);
  const meshes = [0, 1].map((material) => ({ ...mesh, groups: mesh.groups.map((g) => ({ ...g, material })) }));
  const orientation = fromAxisAngle([0, 0, 1], 1);
  const objects = Array.from({ length: 40 }, (_, i) =>
    makeObject({
      path: `/${i}`,
      mesh: meshes[i % 2],
      motion: { kind: 'static', pose: { position: [i, 0, 0], orientation } },
    }),
  );
  const [batch, ...others] = batchesOf(objects, [makeMaterial({ name: 'matt' }), makeMaterial({ name: 'red' })]);
  expect(others).toEqual([]);
  expect(batch.arrays.indices).toHaveLength(mesh.indices.length);
  expect(batch.arrays.positions).toEqual(mesh.positions);
  expect(batch.bodies.map(({ id }) => id)).toEqual(objects.map((_, i) => i + 1));
  expect(batch.instancing).toEqual({ first: 0, materials: objects.map((_, i) => i % 2) });
});

it('bodies with stretches of their own are instances of their mesh, uploaded in its axes', () => {
  const mesh = withoutQuadric(sphere(1));
  const objects = Array.from({ length: 20 }, (_, i) =>
    makeObject({ path: `/${i}`, mesh, motion: restingAt([i, 0, 0]), stretch: [1 + i, 0, 0, 0, 1, 0, 0, 0, 2] }),
  );
  const [batch, ...others] = batchesOf(objects);
  expect(others).toEqual([]);
  expect(batch.instancing?.materials).toHaveLength(20);
  expect(batch.arrays.positions).toHaveLength(mesh.positions.length);
  expect(Math.max(...batch.arrays.positions)).toBeCloseTo(1, 5);
  expect(Math.max(...batch.bodies.map(({ radius }) => radius))).toBeCloseTo(20, 5);
});
