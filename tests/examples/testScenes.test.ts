import { describe, expect, it } from 'vitest';
import { openScene } from '../../src/formats/open.ts';
import { isStatic } from '../../src/scene/motion/motion.ts';
import type { Mesh, Scene } from '../../src/scene/types.ts';
import { validate } from '../../src/scene/validation/validate.ts';
import { files, mean, objectAt, openExample, speedOfLight, worldPositions } from './open.ts';

const triangles = ({ objects }: Scene): number => objects.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);

describe('cubes', async () => {
  const scene = await openScene(files, 'cubes.usdc');

  it('has a checkered floor of 5 m squares', () => {
    const { mesh } = objectAt(scene, '/World/Floor');
    const { baseColorTexture } = scene.materials[mesh.groups[0].material];
    // The picture has 2 × 2 squares.
    const data = baseColorTexture?.data;
    const at = (x: number, y: number): number => data?.[4 * (y * (baseColorTexture?.width ?? 0) + x)] ?? -1;
    const side = (baseColorTexture?.width ?? 0) / 4;
    expect(at(side, side)).toBe(at(3 * side, 3 * side));
    expect(at(side, side)).not.toBe(at(3 * side, side));
    for (let v = 0; v < mesh.positions.length / 3; v++)
      for (let w = 0; w < v; w++) {
        const across = Math.abs(mesh.positions[3 * v] - mesh.positions[3 * w]);
        expect(Math.abs(mesh.uvs[2 * v] - mesh.uvs[2 * w])).toBeCloseTo(across / 10, 5);
      }
  });

  it('has cubes that come, flee and cross at up to 0.9 c, and a ball that turns at 0.62 c', () => {
    const c = speedOfLight(scene);
    const speeds = scene.objects.flatMap(({ motion }) => (motion.kind === 'uniform' ? [motion.velocity] : []));
    expect(speeds.map(([x, , z]) => [x / c, z / c])).toEqual([
      [0, 0.6],
      [0, 0.9],
      [0, -0.45],
      [0, -0.8],
      [0.7, 0],
    ]);
    const { motion, mesh } = objectAt(scene, '/World/Ball');
    if (motion.kind !== 'sampled') throw new Error('the ball is not animated');
    const radius = Math.max(...mesh.positions.filter((_, i) => i % 3 === 0));
    // The angle between two samples from the scalar part of q₁* q₀.
    const [q, r] = [0, 1].map((k) => motion.poses.subarray(7 * k + 3, 7 * k + 7));
    const cosine = q.reduce((sum, x, k) => sum + x * r[k], 0);
    const rate = (2 * Math.acos(Math.abs(cosine))) / (motion.times[1] - motion.times[0]);
    expect((rate * radius) / c).toBeCloseTo(0.62, 2);
  });
});

describe('arcade', () => {
  it('has the size of Sponza, and its file holds equal meshes once', async () => {
    const scene = await openScene(files, 'arcade.usdc');
    expect(triangles(scene)).toBeGreaterThan(250_000);
    const balusters = scene.objects.filter(({ path }) => path.includes('Baluster'));
    expect(balusters.length).toBeGreaterThan(150);
    expect((await files.read('arcade.usdc'))?.length).toBeLessThan(250_000);
    const textured = scene.materials.filter(({ baseColorTexture }) => baseColorTexture).length;
    expect(textured).toBeGreaterThanOrEqual(4);
  });
});

describe('boxes', () => {
  it('are about 1,800, with nothing but six faces at right angles', async () => {
    const scene = await openScene(files, 'boxes.usdc');
    const boxes = scene.objects.filter(({ path }) => path.startsWith('/World/Field'));
    expect(triangles({ ...scene, objects: boxes })).toBe(12 * 1800);
    for (const { mesh, motion } of boxes.slice(0, 4)) {
      expect(isStatic(motion)).toBe(true);
      for (let v = 0; v < mesh.normals.length; v += 3)
        expect([...mesh.normals.subarray(v, v + 3)].map(Math.abs).sort()).toEqual([0, 0, 1]);
    }
  });
});

describe('street', () => {
  it('goes on for half a kilometre with the meshes of its first houses', async () => {
    const scene = await openExample('street');
    for (const name of ['HouseLeft0', 'TreeRight3', 'LampLeft2']) {
      const all = [`/World/${name}`, ...[1, 2, 3, 4].map((k) => `/World/${name}_${k}`)].map(
        (path) => scene.objects.find((object) => object.path === path || object.path.startsWith(`${path}/`))!,
      );
      for (const { mesh } of all) expect(mesh.positions).toEqual(all[0]?.mesh.positions);
      const places = all.map(({ motion }) => (motion.kind === 'static' ? motion.pose.position[2] : Number.NaN));
      places.forEach((z, k) => {
        expect(z).toBeCloseTo(places[0] - 117 * k, 3);
      });
      expect(places[4]).toBeLessThan(-400);
    }
  });
});

describe('drops', async () => {
  const scene = await openScene(files, 'drops.usdc');
  const drops = scene.objects.filter(({ pieceOf }) => pieceOf === '/World/Drops');
  const c = speedOfLight(scene);

  it('is 24 meshes that take turns, from its birth to its death, slower than light', () => {
    expect(drops.map(({ lifetime }) => [lifetime.birth, lifetime.death])).toEqual(
      Array.from({ length: 24 }, (_, k) => [k / 4, (k + 1) / 4]),
    );
    expect(new Set(drops.map(({ mesh }) => mesh.indices.length)).size).toBeGreaterThan(5);
    expect(scene.diagnostics.filter(({ severity }) => severity !== 'info')).toEqual([]);
    expect(validate(scene, c)).toEqual([]);
  });

  it('is closed at every time, and one body or two', () => {
    const bodies = drops.map(({ mesh }) => {
      const points = weldedTriangles(mesh);
      const edges = new Map<string, number>();
      for (const [a, b] of points.flatMap(([a, b, d]) => [
        [a, b],
        [b, d],
        [d, a],
      ]))
        edges.set(`${a} ${b}`, (edges.get(`${a} ${b}`) ?? 0) + 1);
      for (const [edge, count] of edges) expect(edges.get(edge.split(' ').reverse().join(' '))).toBe(count);
      return bodiesOf(points);
    });
    expect(new Set(bodies)).toEqual(new Set([1, 2]));
  });

  it('goes on at 0.55 c', () => {
    // Centres of area: of surfaces that change, their own speed is that of the drops to a few per cent.
    const centers = drops.map((drop) => mean(worldPositions(drop, drop.lifetime.birth, c))[0]);
    expect((centers[20] - centers[4]) / 4 / c).toBeCloseTo(0.55, 1.5);
  });
});

/** Triangles by numbers of places. */
function weldedTriangles({ positions, indices }: Mesh): readonly (readonly [number, number, number])[] {
  const places = new Map<string, number>();
  const placeOf = (vertex: number): number => {
    const key = positions.subarray(3 * vertex, 3 * vertex + 3).join();
    if (!places.has(key)) places.set(key, places.size);
    return places.get(key)!;
  };
  return Array.from({ length: indices.length / 3 }, (_, f) => {
    const [a, b, c] = indices.subarray(3 * f, 3 * f + 3);
    return [placeOf(a), placeOf(b), placeOf(c)] as const;
  });
}

/** How many parts are not connected. */
function bodiesOf(triangles: readonly (readonly number[])[]): number {
  const parent = new Map<number, number>();
  const rootOf = (place: number): number => {
    const up = parent.get(place) ?? place;
    return up === place ? place : rootOf(up);
  };
  for (const triangle of triangles) for (const place of triangle) parent.set(rootOf(place), rootOf(triangle[0]));
  return new Set([...parent.keys()].map(rootOf)).size;
}
