import { describe, expect, it } from 'vitest';
import { vertexPosition } from '../../../../scene/motion/motion.ts';
import type { Scene, SceneObject } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';

const read = (prim: string): Promise<Scene> =>
  readUsd(
    memorySource({
      'a.usda': new TextEncoder().encode(
        `#usda 1.0\n( metersPerUnit = 1\n timeCodesPerSecond = 10\n startTimeCode = 0\n endTimeCode = 20 )\n${prim}\n`,
      ),
    }),
    'a.usda',
  );
const only = async (prim: string): Promise<SceneObject> => {
  const { objects } = await read(prim);
  expect(objects).toHaveLength(1);
  return objects[0];
};

type Point = readonly [number, number, number];
/** Positions in the world at a time [s]. */
const verticesAt = (object: SceneObject, t: number): Point[] =>
  Array.from({ length: object.mesh.positions.length / 3 }, (_, i) => vertexPosition(object, i, t, 3e8) as Point);
const distance = ([a, b, c]: Point, [x, y, z]: Point): number => Math.hypot(a - x, b - y, c - z);

const curve = (type: string, points: readonly Point[], more = '', counts = [points.length]): string =>
  `def ${type} "C" {
  int[] curveVertexCounts = [${counts}]
  point3f[] points = [${points.map((p) => `(${p})`)}]
  ${more}
}`;
const cubic = (basis: string, wrap: string, points: readonly Point[], more = 'float[] widths = [0.02]'): string =>
  curve('BasisCurves', points, `uniform token basis = "${basis}"\nuniform token wrap = "${wrap}"\n${more}`);

describe('points', () => {
  it('are spheres of half their width around them, with their colours', async () => {
    const ball = await only(`def Points "P" {
      point3f[] points = [(0, 0, 0), (10, 0, 0)]
      float[] widths = [2, 4]
      color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0)] ( interpolation = "vertex" )
    }`);
    const { positions, colors, normals } = ball.mesh;
    for (const [i, p] of verticesAt(ball, 0).entries()) {
      const isFirst = p[0] < 5;
      const centre: Point = isFirst ? [0, 0, 0] : [10, 0, 0];
      expect(distance(p, centre)).toBeCloseTo(isFirst ? 1 : 2, 5);
      expect([...colors!.subarray(3 * i, 3 * i + 3)]).toEqual(isFirst ? [1, 0, 0] : [0, 1, 0]);
      const outward = [0, 1, 2].map((k) => (positions[3 * i + k] - centre[k]) / (isFirst ? 1 : 2));
      for (const k of [0, 1, 2]) expect(normals[3 * i + k]).toBeCloseTo(outward[k], 5);
    }
  });

  it('fly by their velocities from one sample, and stay where there are none', async () => {
    const flying = await only(`def Points "P" {
      point3f[] points.timeSamples = { 5: [(1, 0, 0)] }
      vector3f[] velocities.timeSamples = { 5: [(0, 3, 0)] }
      float[] widths = [0.5]
    }`);
    // t₀ is 0.5 s.
    for (const t of [0, 1, 2])
      for (const p of verticesAt(flying, t)) expect(distance(p, [1, 3 * (t - 0.5), 0])).toBeCloseTo(0.25, 5);
  });

  it('move straight between their samples, and grow', async () => {
    const moving = await only(`def Points "P" {
      point3f[] points.timeSamples = { 0: [(0, 0, 0)], 20: [(4, 0, 0)] }
      float[] widths.timeSamples = { 0: [1], 20: [3] }
    }`);
    for (const p of verticesAt(moving, 1)) expect(distance(p, [2, 0, 0])).toBeCloseTo(1, 5);
  });

  it('are drawn evenly where they are too many', async () => {
    const many = Array.from({ length: 200_000 }, (_, i) => `(${i}, 0, 0)`);
    const scene = await read(`def Points "P" {\n point3f[] points = [${many}]\n float[] widths = [1] }`);
    expect(scene.diagnostics.map(({ code }) => code)).toEqual(['usd.strands']);
    expect(scene.objects[0].mesh.indices.length / 3).toBe(8 * 100_000);
  });
});

describe('curves', () => {
  const CORNERS: readonly Point[] = [
    [0, 0, 0],
    [0, 1, 0],
    [1, 1, 0],
    [1, 0, 0],
  ];
  const RADIUS = 0.01;
  const nearest = (points: readonly Point[], to: Point): number => Math.min(...points.map((p) => distance(p, to)));

  const PLACES: readonly (readonly [basis: string, wrap: string, begin: Point, middle: Point, end: Point])[] = [
    // de Casteljau; the mean of the corners' knots; through the corners.
    ['bezier', 'nonperiodic', [0, 0, 0], [0.5, 0.75, 0], [1, 0, 0]],
    ['bspline', 'nonperiodic', [1 / 6, 5 / 6, 0], [0.5, 23 / 24, 0], [5 / 6, 5 / 6, 0]],
    ['catmullRom', 'nonperiodic', [0, 1, 0], [0.5, 1.125, 0], [1, 1, 0]],
    ['bspline', 'pinned', [0, 0, 0], [0.5, 23 / 24, 0], [1, 0, 0]],
    ['catmullRom', 'pinned', [0, 0, 0], [0.5, 1.125, 0], [1, 0, 0]],
  ];
  it.each(PLACES)('%s, %s: begin, middle and end', async (basis, wrap, ...places) => {
    const tube = verticesAt(await only(cubic(basis, wrap, CORNERS)), 0);
    for (const place of places) expect(nearest(tube, place)).toBeCloseTo(RADIUS, 5);
    // Nothing before the begin or after the end.
    const ys = tube.map(([, y]) => y);
    expect(Math.min(...ys)).toBeGreaterThan(places[0][1] - 2 * RADIUS);
  });

  it('close where they are periodic', async () => {
    const tube = verticesAt(await only(cubic('catmullRom', 'periodic', CORNERS)), 0);
    // The segment from the last corner to the first, by symmetry.
    expect(nearest(tube, [0.5, -0.125, 0])).toBeCloseTo(RADIUS, 5);
    expect(nearest(tube, [1.125, 0.5, 0])).toBeCloseTo(RADIUS, 5);
  });

  it('of straight lines have the area of prisms', async () => {
    const line = await only(
      curve(
        'BasisCurves',
        [
          [0, 0, 0],
          [3, 0, 0],
        ],
        'uniform token type = "linear"\nfloat[] widths = [2, 2]',
      ),
    );
    const { positions, indices } = line.mesh;
    const p = (i: number): Point => [positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]];
    let [area, volume] = [0, 0];
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = [p(indices[i]), p(indices[i + 1]), p(indices[i + 2])];
      const [u, v] = [b, c].map((q) => q.map((x, k) => x - a[k]));
      const n = [0, 1, 2].map((k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]);
      area += Math.hypot(...n) / 2;
      volume += (a[0] * n[0] + a[1] * n[1] + a[2] * n[2]) / 6;
    }
    // A prism of ten sides with lids, in a circle of radius 1, and outside out.
    const face = 5 * Math.sin(Math.PI / 5);
    expect(area).toBeCloseTo(3 * 20 * Math.sin(Math.PI / 10) + 2 * face, 5);
    expect(volume).toBeCloseTo(3 * face, 5);
  });

  it('are ribbons across their normals', async () => {
    const ribbon = await only(
      curve(
        'BasisCurves',
        [
          [0, 0, 0],
          [4, 0, 0],
        ],
        'uniform token type = "linear"\nfloat[] widths = [1, 3] ( interpolation = "varying" )\nnormal3f[] normals = [(0, 0, 1), (0, 0, 1)]',
      ),
    );
    expect(ribbon.mesh.doubleSided).toBe(true);
    const found = verticesAt(ribbon, 0).map((p) => p.map((x) => Math.round(1e5 * x) / 1e5 + 0));
    expect(found.sort((a, b) => a[0] - b[0] || a[1] - b[1])).toEqual([
      [0, -0.5, 0],
      [0, 0.5, 0],
      [4, -1.5, 0],
      [4, 1.5, 0],
    ]);
    expect([...ribbon.mesh.normals.subarray(0, 3)].map(Math.abs)).toEqual([0, 0, 1]);
  });

  it('have values of each interpolation', async () => {
    const two = await only(
      curve(
        'BasisCurves',
        [
          [0, 0, 0],
          [1, 0, 0],
          [0, 9, 0],
          [1, 9, 0],
        ],
        'uniform token type = "linear"\nfloat[] widths = [0.1, 0.2] ( interpolation = "uniform" )\ncolor3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)] ( interpolation = "varying" )',
        [2, 2],
      ),
    );
    for (const [i, p] of verticesAt(two, 0).entries()) {
      const [x, y] = [Math.round(p[0]), Math.round(p[1] / 9) * 9];
      expect(distance(p, [x, y, 0])).toBeCloseTo(y === 0 ? 0.05 : 0.1, 5);
      const color = y === 0 ? (x === 0 ? [1, 0, 0] : [0, 1, 0]) : x === 0 ? [0, 0, 1] : [1, 1, 1];
      expect([...two.mesh.colors!.subarray(3 * i, 3 * i + 3)]).toEqual(color);
    }
  });

  it('of NURBS are exact circles', async () => {
    const w = Math.SQRT1_2;
    const points: Point[] = [
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 0],
      [-1, 1, 0],
      [-1, 0, 0],
      [-1, -1, 0],
      [0, -1, 0],
      [1, -1, 0],
      [1, 0, 0],
    ];
    const ring = await only(
      curve(
        'NurbsCurves',
        points,
        `int[] order = [3]\ndouble[] knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]\ndouble[] pointWeights = [1, ${w}, 1, ${w}, 1, ${w}, 1, ${w}, 1]\nfloat[] widths = [0.02]`,
      ),
    );
    for (const [x, y, z] of verticesAt(ring, 0)) {
      const around = Math.hypot(x, y);
      expect(Math.hypot(around - 1, z)).toBeCloseTo(RADIUS, 4);
    }
  });

  it('that need points which they do not have are reported', async () => {
    const { objects, diagnostics } = await read(curve('BasisCurves', CORNERS, '', [5]));
    expect(objects).toEqual([]);
    expect(diagnostics.map(({ code }) => code)).toEqual(['usd.strands', 'usd.empty-mesh']);
  });
});
