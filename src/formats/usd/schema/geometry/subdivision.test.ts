import { describe, expect, it } from 'vitest';
import { pointsAt } from '../../../../scene/streaming/samplePoints.ts';
import type { Mesh, Scene } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import type { ReadOptions } from '../../../readOptions.ts';
import { placeAndMessage } from '../../fixtures/said.ts';
import { readUsd } from '../../read.ts';

const readAsIs = (body: string, options: ReadOptions = {}): Promise<Scene> => {
  const text = `#usda 1.0\n(\nmetersPerUnit = 1\n)\n${body}\n`;
  return readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda', options);
};
const read = (body: string, subdivision = 2): Promise<Scene> => readAsIs(body, { subdivision });
const said = (scene: Scene): string[] => scene.diagnostics.map((d) => `${d.severity} ${d.code} ${placeAndMessage(d)}`);

const FACES = `
  int[] faceVertexCounts = [4, 4, 4, 4, 4, 4]
  int[] faceVertexIndices = [0, 1, 3, 2, 2, 3, 5, 4, 4, 5, 7, 6, 6, 7, 1, 0, 1, 7, 5, 3, 6, 0, 2, 4]`;
const POINTS = '[(-1, -1, 1), (1, -1, 1), (-1, 1, 1), (1, 1, 1), (-1, 1, -1), (1, 1, -1), (-1, -1, -1), (1, -1, -1)]';
const cube = (more = '', name = 'Box'): string =>
  `def Mesh "${name}" {${FACES}\n  point3f[] points = ${POINTS}\n  ${more}\n}`;
const triangles = ({ indices }: Mesh): number => indices.length / 3;
/** Greatest |x|, |y| or |z|. */
const reach = ({ positions }: Mesh): number => positions.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

describe('a mesh without a scheme', () => {
  it('is a Catmull–Clark surface of two levels, welded, with smooth normals', async () => {
    const scene = await read(cube());
    const { mesh } = scene.objects[0];
    expect(triangles(mesh)).toBe(6 * 16 * 2);
    expect(mesh.positions.length / 3).toBe(98);
    // The centre of a face, by the limit mask of a regular point one level finer: (16 q + 4 Σ e + Σ f) / 36.
    const edges = 0.75;
    const corner = (3 / 8) * 1 + (4 / 24) * 1 + (1 / 24) * -1;
    expect(corner).toBeCloseTo(0.5, 12);
    expect(reach(mesh)).toBeCloseTo((16 * 1 + 4 * 4 * edges + 4 * (5 / 9)) / 36, 5);
    expect(said(scene)).toEqual([]);
  });

  it('has the requested levels; with 0 it is its polygons, which is reported', async () => {
    for (const [levels, faces] of [
      [1, 24],
      [3, 384],
    ]) {
      expect(triangles((await read(cube(), levels)).objects[0].mesh)).toBe(2 * faces);
    }
    const polygons = await read(cube(), 0);
    expect(triangles(polygons.objects[0].mesh)).toBe(12);
    expect(said(polygons)).toEqual([
      'info usd.subdivision a.usda: /Box is meant as subdivision surface; it is drawn as its polygons',
    ]);
  });

  it('is refined until it looks smooth by default', async () => {
    const [box] = (await readAsIs(cube())).objects;
    expect(triangles(box.mesh)).toBe(2 * 384);
  });

  it('follows its animated points, and its normals too', async () => {
    const double = POINTS.replaceAll(/1/g, '2');
    const scene = await read(
      cube(`point3f[] points.timeSamples = { 0: ${POINTS}, 24: ${double} }`).replace(
        `point3f[] points = ${POINTS}`,
        '',
      ),
    );
    const { motion, mesh } = scene.objects[0];
    if (motion.kind !== 'sampled-points') throw new Error(motion.kind);
    const before = pointsAt(motion, 0);
    pointsAt(motion, 1).forEach((x, i) => {
      expect(x).toBeCloseTo(2 * before[i], 5);
    });
    motion.normals![1].forEach((x, i) => {
      expect(x).toBeCloseTo(mesh.normals[i], 5);
    });
  });
});

describe('features of the surface', () => {
  it('creases, with one sharpness each or one for each edge', async () => {
    const loop = 'int[] creaseIndices = [2, 3, 5, 4, 2]; int[] creaseLengths = [5]';
    const top = (mesh: Mesh): number =>
      mesh.positions.reduce((most, y, i) => (i % 3 === 1 ? Math.max(most, y) : most), 0);
    const sharp = await read(cube(`${loop}; float[] creaseSharpnesses = [10]`));
    const each = await read(cube(`${loop}; float[] creaseSharpnesses = [10, 10, 10, 10]`));
    expect(top(sharp.objects[0].mesh)).toBe(1);
    expect([...each.objects[0].mesh.positions]).toEqual([...sharp.objects[0].mesh.positions]);
    // A crease has two normals: the vertices on its 16 edges are doubled.
    expect(sharp.objects[0].mesh.positions.length / 3).toBe(98 + 16);
  });

  it('corners and holes; a hole still shapes its neighbourhood', async () => {
    const scene = await read(
      cube('int[] cornerIndices = [3]; float[] cornerSharpnesses = [10]; int[] holeIndices = [5]'),
    );
    const { mesh } = scene.objects[0];
    expect(triangles(mesh)).toBe(5 * 16 * 2);
    const places = Array.from({ length: mesh.positions.length / 3 }, (_, v) =>
      [...mesh.positions.subarray(3 * v, 3 * v + 3)].join(),
    );
    expect(places).toContain('1,1,1');
    const whole = (await read(cube('int[] cornerIndices = [3]; float[] cornerSharpnesses = [10]'))).objects[0].mesh;
    const all = new Set(
      Array.from({ length: whole.positions.length / 3 }, (_, v) =>
        [...whole.positions.subarray(3 * v, 3 * v + 3)].join(),
      ),
    );
    expect(places.every((place) => all.has(place))).toBe(true);
  });

  it('schemes and boundaries', async () => {
    const sheet = (more: string): string => `def Mesh "Sheet" {
  int[] faceVertexCounts = [4]; int[] faceVertexIndices = [0, 1, 2, 3]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
  ${more} }`;
    const area = async (more: string): Promise<number> => {
      const scene = await read(sheet(more), 3);
      const mesh = scene.objects[0]?.mesh;
      if (!mesh) return 0;
      let sum = 0;
      for (let i = 0; i < mesh.indices.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map((k) =>
          mesh.positions.subarray(3 * mesh.indices[i + k], 3 * mesh.indices[i + k] + 2),
        );
        sum += ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
      }
      return sum;
    };
    expect(await area('')).toBeCloseTo(1, 5);
    expect(await area('uniform token subdivisionScheme = "bilinear"')).toBeCloseTo(1, 5);
    expect(await area('uniform token interpolateBoundary = "edgeOnly"')).toBeLessThan(0.8);
    expect(await area('uniform token interpolateBoundary = "none"')).toBe(0);
  });

  it('Loop requires triangles, and others are reported', async () => {
    const loop = 'uniform token subdivisionScheme = "loop"';
    const scene = await read(cube(loop));
    expect(triangles(scene.objects[0].mesh)).toBe(12);
    expect(said(scene)).toEqual([
      'warning usd.subdivision a.usda</Box>: subdivisionScheme loop takes triangles only; it is drawn as its polygons',
    ]);
    const tetrahedron = `def Mesh "T" { int[] faceVertexCounts = [3, 3, 3, 3]; int[] faceVertexIndices = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]
      point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]; ${loop} }`;
    expect(triangles((await read(tetrahedron)).objects[0].mesh)).toBe(4 * 16);
  });

  it('uv seams stay seams, and subsets keep their faces', async () => {
    const scene = await read(`${cube(`
  texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] ( interpolation = "faceVarying" )
  int[] primvars:st:indices = [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3]
  def GeomSubset "Lid" { uniform token elementType = "face"; int[] indices = [1]; rel material:binding = </Red> }`)}
def Material "Red" { token outputs:surface.connect = </Red/S.outputs:surface>
  def Shader "S" { uniform token info:id = "UsdPreviewSurface"; color3f inputs:diffuseColor = (1, 0, 0); token outputs:surface } }`);
    const { mesh } = scene.objects[0];
    expect(mesh.groups.map(({ count }) => count / 3).sort((a, b) => a - b)).toEqual([32, 160]);
    const corners = new Set(
      Array.from({ length: mesh.uvs.length / 2 }, (_, v) => `${mesh.uvs[2 * v]},${mesh.uvs[2 * v + 1]}`),
    );
    for (const corner of ['0,0', '1,0', '1,1', '0,1']) expect(corners).toContain(corner);
  });
});

/** A sheet of n × n squares, 1 wide each, with heights by place. */
function sheet(n: number, height: (x: number, y: number) => number, more = ''): string {
  const points = Array.from({ length: (n + 1) ** 2 }, (_, p) => [p % (n + 1), Math.floor(p / (n + 1))]);
  const indices = Array.from({ length: n * n }, (_, f) => {
    const p = (f % n) + (n + 1) * Math.floor(f / n);
    return [p, p + 1, p + n + 2, p + n + 1];
  });
  return `def Mesh "Large" { int[] faceVertexCounts = [${Array(n * n).fill(4)}]; int[] faceVertexIndices = [${indices.flat()}]
  point3f[] points = [${points.map(([x, y]) => `(${x}, ${y}, ${height(x, y)})`)}]; ${more} }`;
}

describe('levels by default', () => {
  const hill = (x: number, y: number): number => 2 * Math.sin(x / 8) * Math.cos(y / 8);

  it('are those that a picture of 1080 rows shows; 0 has the faces of the cage on the limit surface', async () => {
    const scene = await readAsIs(sheet(24, hill));
    const [{ mesh }] = scene.objects;
    expect(triangles(mesh)).toBe(24 * 24 * 2);
    expect(said(scene)).toEqual([
      'info usd.subdivision a.usda: /Large is subdivided 0 times: more would change about a pixel or less where it fills a picture of 1080 rows',
    ]);
    // Each of its vertices is one of the surface that is subdivided once, with its normal; the cage's points are not.
    const once = (await readAsIs(sheet(24, hill), { subdivision: 1 })).objects[0].mesh;
    const key = (of: Float32Array, v: number): string => [0, 1, 2].map((k) => of[3 * v + k].toFixed(4)).join();
    const normals = new Map(
      Array.from({ length: once.positions.length / 3 }, (_, v) => [key(once.positions, v), key(once.normals, v)]),
    );
    for (let v = 0; v < mesh.positions.length / 3; v++)
      expect(normals.get(key(mesh.positions, v))).toBe(key(mesh.normals, v));
    const cage = new Set(Array.from({ length: 25 * 25 }, (_, p) => hill(p % 25, Math.floor(p / 25)).toFixed(4)));
    const heights = Array.from({ length: mesh.positions.length / 3 }, (_, v) => mesh.positions[3 * v + 2].toFixed(4));
    expect(heights.filter((z) => cage.has(z)).length).toBeLessThan(heights.length / 2);
  });

  it('are none for what is flat, which is not worth a word', async () => {
    const scene = await readAsIs(sheet(3, (x, y) => x + 3 * y));
    expect(triangles(scene.objects[0].mesh)).toBe(3 * 3 * 2);
    expect(said(scene)).toEqual([]);
  });

  it('are more for points that move, which may bend more later, and as many as are requested', async () => {
    const [, points] = /point3f\[\] points = (.*?\]);/.exec(sheet(8, hill))!;
    const moving = `point3f[] points.timeSamples = { 0: ${points}, 24: ${points.replaceAll('(', '(1')} }`;
    const [object] = (await readAsIs(sheet(8, hill).replace(/point3f.*?\];/, moving))).objects;
    expect(object.motion.kind).toBe('sampled-points');
    expect(triangles(object.mesh)).toBe(8 * 8 * 16 * 2);
    expect(triangles((await readAsIs(sheet(8, hill), { subdivision: 1 })).objects[0].mesh)).toBe(8 * 8 * 4 * 2);
  });

  it('keep creases: a cage with them has both normals there', async () => {
    const folded = sheet(
      8,
      (x) => Math.abs(x - 4),
      'int[] creaseIndices = [4, 13, 22, 31, 40, 49, 58, 67, 76]; int[] creaseLengths = [9]; float[] creaseSharpnesses = [10]',
    );
    const [{ mesh }] = (await readAsIs(folded)).objects;
    expect(triangles(mesh)).toBe(8 * 8 * 2);
    expect(mesh.positions.length / 3).toBe(9 * 9 + 9);
    expect(mesh.positions.filter((_, i) => i % 3 === 2).reduce((a, b) => Math.min(a, b))).toBe(0);
  });
});

describe('a face budget', () => {
  it('is shared: the largest meshes have fewer levels, which is reported', async () => {
    const n = 200;
    const scene = await readAsIs(`${sheet(n, (x, y) => 20 * ((x + y) % 2))}\n${cube()}`);
    expect(scene.objects.map(({ mesh }) => triangles(mesh))).toEqual([4 * n * n * 2, 768]);
    expect(said(scene)).toEqual([
      "info usd.subdivision a.usda</Large>: it is subdivided 1 times, not 2: a scene's surfaces share 500,000 faces, instances counted 1,000,000",
    ]);
  });
});

describe('a budget of faces that are drawn', () => {
  it('counts instances, unless levels are requested', async () => {
    const instances = Array.from(
      { length: 3000 },
      (_, k) => `def "I${k}" ( instanceable = true; references = </_class> ) {}`,
    );
    const stage = `class "_class" { ${cube()} }\n${instances.join('\n')}`;
    // 3 levels alone: 384 faces of 2 triangles.
    const scene = await readAsIs(stage);
    expect(scene.objects).toHaveLength(3000);
    expect(new Set(scene.objects.map(({ mesh }) => mesh)).size).toBe(1);
    expect(triangles(scene.objects[0].mesh)).toBe(192);
    const requested = await readAsIs(stage, { subdivision: 3 });
    expect(triangles(requested.objects[0].mesh)).toBe(768);
  });
});

describe('the budget of meshes that are fine already', () => {
  it('is left to others', async () => {
    const instances = (of: string): string[] =>
      Array.from({ length: 100 }, (_, k) => `def "${of}${k}" ( instanceable = true; references = </${of}> ) {}`);
    // Of 24 × 24 faces, 100 times: with two levels of both there would be 1.8 million.
    const [fine, rough] = [sheet(24, (x) => Math.sin(x / 9)), sheet(24, (x, y) => 2 * ((x + y) % 2))];
    const stage = `class "_fine" { ${fine} }\nclass "_rough" { ${rough} }\n${[...instances('_fine'), ...instances('_rough')].join('\n')}`;
    const { objects } = await readAsIs(stage);
    expect(objects.map(({ mesh }) => triangles(mesh))).toEqual([
      ...Array(100).fill(2 * 24 * 24),
      ...Array(100).fill(2 * 16 * 24 * 24),
    ]);
  });
});

describe('faults', () => {
  it('of creases, corners and tokens are reported, and the surface is still built', async () => {
    const scene = await read(
      cube(`int[] creaseIndices = [0, 99]; int[] creaseLengths = [2]; float[] creaseSharpnesses = [1]
  int[] cornerIndices = [1, 2]; float[] cornerSharpnesses = [nan]
  uniform token interpolateBoundary = "round"`),
    );
    expect(said(scene).map((text) => text.replace('warning usd.subdivision a.usda</Box>: ', ''))).toEqual([
      'creaseIndices names points that are not there; the creases are left out',
      "interpolateBoundary 'round' is not none, edgeOnly, edgeAndCorner; edgeAndCorner is taken",
      'cornerIndices and cornerSharpnesses do not fit each other or the points; the corners are left out',
    ]);
    expect(triangles(scene.objects[0].mesh)).toBe(192);
  });

  it('a repeated corner does not make an edge of length 0', async () => {
    const text = `def Mesh "M" { int[] faceVertexCounts = [4, 3]; int[] faceVertexIndices = [0, 1, 2, 2, 0, 2, 0]
      point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)] }`;
    const { mesh } = (await read(text, 1)).objects[0];
    expect(triangles(mesh)).toBe(6);
    expect([...mesh.positions, ...mesh.normals].every(Number.isFinite)).toBe(true);
  });
});
