import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../math/vec3.ts';
import { inEnglish } from '../../../messages/message.ts';
import { vertexPosition } from '../../../scene/motion/motion.ts';
import { pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { Scene, SceneObject } from '../../../scene/types.ts';
import { memorySource } from '../../files/fileSource.ts';
import { encodePng } from '../../image/encodePng.ts';
import { readUsd } from '../read.ts';

/** c [m/s], far above every speed here. */
const C = 3e8;

interface Expected {
  readonly times: readonly number[];
  readonly codesPerSecond: number;
  readonly unit: number;
  readonly prims: Record<
    string,
    { type: string; matrices: number[][]; points?: number[][]; normals?: number[][]; fovY?: number }
  >;
}

const file = (name: string): Uint8Array => readFileSync(new URL(`../fixtures/${name}`, import.meta.url));
const expectedStage = (name: string): Expected =>
  JSON.parse(new TextDecoder().decode(file(`${name}.expected.json`)), (_, v) => (v === '-0' ? -0 : v)).stage;

const CHECKER = encodePng(2, 1, Uint8Array.of(255, 255, 255, 255, 0, 0, 0, 64));
const read = (name: string): Promise<Scene> =>
  readUsd(memorySource({ [`${name}.usda`]: file(`${name}.usda`), 'checker.png': CHECKER }), `${name}.usda`);

/** x′ = x M for row vectors and a row-major matrix, as in USD. */
const rowTransform = (m: readonly number[], p: Vec3): Vec3 =>
  [0, 1, 2].map((k) => p[0] * m[k] + p[1] * m[4 + k] + p[2] * m[8 + k] + m[12 + k]) as unknown as Vec3;

const vertices = (object: SceneObject, t: number): Vec3[] =>
  Array.from({ length: object.mesh.positions.length / 3 }, (_, i) => vertexPosition(object, i, t, C));

const distance = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const nearest = (p: Vec3, points: readonly Vec3[]): number => Math.min(...points.map((q) => distance(p, q)));

const cubeCorners = (size: number): Vec3[] =>
  Array.from({ length: 8 }, (_, i) => [0, 1, 2].map((k) => ((i >> k) & 1 ? size : -size) / 2) as unknown as Vec3);

const SIZES: Record<string, number> = { '/World/Still': 1, '/World/Spinning/Arm': 0.5 };

describe('transforms agree with usd-core at every time', async () => {
  const scene = await read('xforms');
  const stage = expectedStage('xforms');
  const cubes = Object.entries(stage.prims).filter(([, prim]) => prim.type === 'Cube');

  it('reads every cube', () => {
    expect(scene.objects.map((o) => o.path).sort()).toEqual(cubes.map(([path]) => path));
  });

  it('reports where a blocked sample makes an object jump', () => {
    expect(scene.diagnostics.map((d) => [d.code, d.place])).toEqual([
      ['usd.resampling', 'xforms.usda</World/Tumbling>'],
    ]);
  });

  it.each(cubes)('%s', (path, prim) => {
    const object = scene.objects.find((o) => o.path === path)!;
    const corners = cubeCorners(SIZES[path] ?? 2);
    stage.times.forEach((code, i) => {
      const expected = corners.map(
        (c) => rowTransform(prim.matrices[i], c).map((x) => x * stage.unit) as unknown as Vec3,
      );
      const actual = vertices(object, code / stage.codesPerSecond);
      // The chord tolerance, 1e-4 of the object's size, and f32.
      for (const p of actual) expect(nearest(p, expected), `${code}`).toBeLessThan(6e-4);
      for (const q of expected) expect(nearest(q, actual), `${code}`).toBeLessThan(6e-4);
    });
  });

  it('chooses the motion kind', () => {
    const kind = (name: string) => scene.objects.find((o) => o.path === `/World/${name}`)!.motion.kind;
    expect(kind('Still')).toBe('static');
    expect(kind('Sheared')).toBe('static');
    expect(kind('SameSamples')).toBe('static');
    expect(kind('DefaultAndSamples')).toBe('static');
    expect(kind('Pivot')).toBe('sampled');
    expect(kind('Spinning/Arm')).toBe('sampled');
    expect(kind('Tumbling')).toBe('sampled');
    expect(kind('Breathing')).toBe('sampled-points');
  });

  it('keeps a reflected cube facing outwards', () => {
    const { mesh } = scene.objects.find((o) => o.path === '/World/Sheared')!;
    for (let i = 0; i < mesh.indices.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) =>
        Array.from(mesh.positions.subarray(3 * mesh.indices[i + k], 3 * mesh.indices[i + k] + 3)),
      );
      const [u, v] = [b.map((x, k) => x - a[k]), c.map((x, k) => x - a[k])];
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      expect(normal[0] * a[0] + normal[1] * a[1] + normal[2] * a[2]).toBeGreaterThan(0);
    }
  });

  it.each(['/World/Eye', '/World/Fallback'])('the camera %s', (path) => {
    const camera = scene.cameras.find((c) => c.path === path)!;
    const prim = stage.prims[path];
    expect(camera.fovY).toBeCloseTo(prim.fovY!, 6);
    const { mesh } = scene.objects[0];
    const object: SceneObject = {
      path,
      mesh: { ...mesh, positions: Float32Array.of(0, 0, 0, 0, 0, -1, 0, 1, 0) },
      motion: camera.motion,
      lifetime: { birth: 0, death: 1 },
      authoredIn: 'world',
    };
    stage.times.forEach((code, i) => {
      const [eye, front, up] = vertices(object, code / stage.codesPerSecond);
      const m = prim.matrices[i];
      const at = rowTransform(m, [0, 0, 0]).map((x) => x * stage.unit) as unknown as Vec3;
      expect(distance(eye, at)).toBeLessThan(1e-3);
      for (const [tip, axis] of [
        [front, [0, 0, -1]],
        [up, [0, 1, 0]],
      ] as const) {
        const d = rowTransform(m, axis).map((x, k) => x - rowTransform(m, [0, 0, 0])[k]);
        const l = Math.hypot(...d);
        expect(
          distance([tip[0] - eye[0], tip[1] - eye[1], tip[2] - eye[2]], [d[0] / l, d[1] / l, d[2] / l]),
        ).toBeLessThan(1e-3);
      }
    });
  });

  it('has the stage’s times in seconds and its units', () => {
    expect(scene).toMatchObject({ startTime: 0, endTime: 2, metersPerUnit: 0.5, upAxis: 'Y', timeCodesPerSecond: 10 });
  });
});

describe('meshes', async () => {
  const scene = await read('meshes');
  const stage = expectedStage('meshes');
  const object = (name: string): SceneObject => scene.objects.find((o) => o.path === `/World/${name}`)!;

  it.each(['Quads', 'LeftHanded', 'Holes', 'Waving', 'Bound'])('the points of %s agree with usd-core', (name) => {
    const prim = stage.prims[`/World/${name}`];
    stage.times.forEach((code, i) => {
      const flat = prim.points![i];
      const points = Array.from({ length: flat.length / 3 }, (_, k) =>
        rowTransform(prim.matrices[i], [flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]]),
      );
      for (const p of vertices(object(name), code / stage.codesPerSecond))
        expect(nearest(p, points)).toBeLessThan(2e-6);
    });
  });

  it('stores points near a distant origin with f32 accuracy of their size, not of their distance', () => {
    const { motion } = object('Waving');
    if (motion.kind !== 'sampled-points') throw new Error(motion.kind);
    for (let k = 0; k < motion.times.length; k++)
      expect(Math.max(...pointsAt(motion, k).map(Math.abs))).toBeLessThan(20);
    expect(Array.from(motion.times)).toEqual([0, 1, 1.5, 2]);
    // At 24, halfway, the mean of both normals, rotated by 90° about z and normalized.
    const l = Math.hypot(0.3, 0.9);
    expect(Array.from(motion.normals![1].subarray(0, 3))).toEqual(
      [-0.3 / l, 0, 0.9 / l].map((x) => expect.closeTo(x, 6)),
    );
  });

  it('triangulates n-gons and gives their faces uvs and colours', () => {
    const { mesh } = object('Quads');
    expect(mesh.indices.length / 3).toBe(2 + 1 + 3);
    const rows = Array.from({ length: mesh.positions.length / 3 }, (_, i) =>
      [
        ...mesh.positions.subarray(3 * i, 3 * i + 2),
        ...mesh.uvs.subarray(2 * i, 2 * i + 2),
        ...mesh.colors!.subarray(3 * i, 3 * i + 3),
      ].join(' '),
    );
    expect(rows).toContain('1 0 1 0 1 0 0');
    expect(rows).toContain('1 0 0 0 0 1 0');
    expect(rows).toContain('2 0.5 1 0 0 0 1');
  });

  it('flips left-handed faces, and keeps authored normals', () => {
    const { mesh } = object('LeftHanded');
    expect(mesh.doubleSided).toBe(true);
    expect(Array.from(mesh.normals.subarray(0, 3))).toEqual([0, 0, -1]);
    const [a, b, c] = [0, 1, 2].map((k) => mesh.positions.subarray(3 * mesh.indices[k], 3 * mesh.indices[k] + 2));
    expect((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).toBeLessThan(0);
    expect(scene.materials[mesh.groups[0].material]).toMatchObject({ baseColor: [0.25, 0.5, 0.75], opacity: 0.5 });
  });

  it('skips holes, and keeps the uvs of later faces', () => {
    const { mesh } = object('Holes');
    expect(mesh.indices.length).toBe(6);
    expect(Array.from(mesh.uvs.filter((_, i) => i % 2 === 0)).sort()).toEqual([0, 1, 2, 6, 7, 8]);
  });

  it('binds materials by subset, inherits them, and respects stronger bindings', () => {
    const names = (name: string) => object(name).mesh.groups.map((g) => [g.count, scene.materials[g.material].name]);
    expect(names('Bound')).toEqual([
      [6, '/Looks/Red'],
      [3, '/Looks/Textured'],
    ]);
    expect(names('Strong/Ball')).toEqual([[expect.any(Number), '/Looks/Textured']]);
  });

  it('reads UsdPreviewSurface, its interface inputs and its textures', () => {
    const material = (name: string) => scene.materials.find((m) => m.name === name)!;
    expect(material('/Looks/Red')).toEqual({
      name: '/Looks/Red',
      baseColor: [1, Math.fround(0.1), Math.fround(0.2)],
      emissive: [0, 0.5, 1],
      roughness: 0.25,
      metallic: 1,
      opacity: 0.75,
      opacityThreshold: 0,
    });
    expect(material('/Looks/Textured')).toMatchObject({
      baseColor: [0.5, 1, 1],
      opacityThreshold: 0.5,
      baseColorTexture: {
        name: 'checker.png',
        width: 2,
        colorSpace: 'srgb',
        filter: 'nearest',
        wrapS: 'clamp',
        wrapT: 'mirror',
      },
    });
    expect(Array.from(material('/Looks/Textured').baseColorTexture!.data)).toEqual([255, 255, 255, 255, 0, 0, 0, 64]);
  });

  it('transforms uvs by UsdTransform2d, only on the faces of its material', () => {
    const { mesh } = object('Bound');
    const uvsOf = (group: number) =>
      Array.from(mesh.indices.subarray(mesh.groups[group].start, mesh.groups[group].start + 3), (v) =>
        Array.from(mesh.uvs.subarray(2 * v, 2 * v + 2), (x) => Math.round(x * 1e4) / 1e4),
      );
    expect(uvsOf(0)).toEqual([
      [0, 0],
      [1, 0],
      [1, 1],
    ]);
    // scale (2, 3), then a quarter turn: (u, v) → (−3v, 2u), then + (10, 20)
    expect(uvsOf(1)).toEqual([
      [10, 20],
      [7, 22],
      [7, 20],
    ]);
  });

  it('reads parametric shapes, with their sizes and axes', () => {
    const extent = (name: string) => {
      const { positions } = object(name).mesh;
      return [0, 1, 2].map((k) => Math.max(...positions.filter((_, i) => i % 3 === k)));
    };
    expect(extent('Strong/Ball')).toEqual([2.5, 2.5, 2.5]);
    expect(extent('Tall')).toEqual([3, 0.5, 0.5]);
    expect(extent('Hat')).toEqual([1, 1, 1]);
    expect(extent('Pill')).toEqual([0.5, 0.5, 1]);
    expect(extent('Floor')).toEqual([5, 0, 2]);
  });

  it('skips proxy, invisible and inactive prims', () => {
    for (const name of ['Proxy', 'Hidden/Child', 'Inactive']) expect(object(name)).toBeUndefined();
  });

  it('reads lights', () => {
    const light = (kind: string) => scene.lights.find((l) => l.kind === kind)!;
    const { matrices } = stage.prims['/Lights/Sun'];
    const towards = rowTransform(matrices[0], [0, 0, -1]);
    const sun = light('distant');
    if (sun.kind !== 'distant') throw new Error(sun.kind);
    expect(distance(sun.direction, towards)).toBeLessThan(1e-6);
    expect(sun.color).toEqual([6, 5.4, 4.8].map((x) => expect.closeTo(x, 5)));
    expect(light('sphere')).toMatchObject({
      motion: { pose: { position: [1, 2, 3] } },
      radius: 0.5,
      color: [40, 40, 40],
    });
    expect(light('dome')).toMatchObject({ color: [0.1, 0.2, 0.5].map((x) => expect.closeTo(x, 6)) });
  });

  it('reports nothing but undersampled motion', () => {
    expect(scene.diagnostics.map((d) => [d.severity, d.code, d.place])).toEqual([
      ['info', 'usd.between-samples', 'meshes.usda</World/Waving>'],
    ]);
  });
});

describe('numerous transforms in a small file', () => {
  const text = (body: string) => memorySource({ 'a.usda': new TextEncoder().encode(`#usda 1.0\n${body}`) });

  it('are limited to the first few thousand of a prim, and the rest is reported', async () => {
    const order = Array.from({ length: 5000 }, (_, i) => `"xformOp:translate${i % 2 ? ':b' : ''}"`);
    const scene = await readUsd(
      text(`( metersPerUnit = 1 )
def Cube "A" {
  double3 xformOp:translate = (1, 0, 0)
  double3 xformOp:translate:b = (0, 1, 0)
  uniform token[] xformOpOrder = [${order}]
}`),
      'a.usda',
    );
    expect(scene.objects[0].motion).toMatchObject({ kind: 'static', pose: { position: [2048, 2048, 0] } });
    expect(scene.diagnostics.map(({ code, message }) => [code, /5000 transforms/.test(inEnglish(message))])).toEqual([
      ['usd.xform-op', true],
    ]);
  });

  it.each([
    ['0: (0, 0, 0), 4: (4, 0, 0), 8: (4, 8, 0)', [0, 4, 8]],
    ['0: (0, 0, 0), 4: None, 8: (4, 8, 0)', [0, 4, 8]],
  ])('are linear between samples if so specified: %s', async (samples, codes) => {
    const scene = await readUsd(
      text(`( metersPerUnit = 1
timeCodesPerSecond = 1 )
def Xform "A" {
  double3 xformOp:translate.timeSamples = { ${samples} }
  float3 xformOp:scale = (1, 2, 3)
  uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
  def Cube "B" {
    float3 xformOp:translate = (1, 1, 1)
    uniform token[] xformOpOrder = ["xformOp:translate"]
  }
}`),
      'a.usda',
    );
    const { motion } = scene.objects[0];
    const times = 'times' in motion ? [...motion.times] : [];
    // Blocked samples jump, and are resampled at ever shorter intervals.
    if (samples.includes('None')) expect(times.length).toBeGreaterThan(10);
    else expect(times).toEqual(codes);
    const x = (t: number) => Math.max(...vertices(scene.objects[0], t).map((p) => p[0]));
    expect(x(2)).toBeCloseTo(samples.includes('None') ? 2 : 4, 6);
    expect(x(8)).toBeCloseTo(6, 6);
  });
});
