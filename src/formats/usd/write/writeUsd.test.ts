import { describe, expect, it } from 'vitest';
import { toHalf } from '../../../math/half.ts';
import { sphere } from '../../../scene/mesh/primitives.ts';
import { pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { DistantLight, Material, Mesh, Scene, SceneObject, Texture } from '../../../scene/types.ts';
import { memorySource } from '../../files/fileSource.ts';
import { contentBytes } from '../../files/rangedFile.ts';
import { openPackage } from '../assets/usdz.ts';
import { readCrate } from '../crate/readCrate.ts';
import { readUsd } from '../read.ts';
import { parseLayer } from '../text/parser.ts';
import { floatText } from './numberText.ts';
import { primName } from './primTree.ts';
import { writeTextures, writeUsda, writeUsdc, writeUsdz } from './writeUsd.ts';

const texture = (name: string, alpha: number, seed: number): Texture => ({
  name,
  width: 2,
  height: 2,
  data: Uint8Array.from({ length: 16 }, (_, i) => (i % 4 === 3 ? alpha : (i * seed) % 256)),
  colorSpace: 'srgb',
  filter: 'nearest',
  wrapS: 'clamp',
  wrapT: 'mirror',
});

const always = { birth: -Infinity, death: Infinity };
const pose = { position: [0.1, -2e3, 1 / 3], orientation: [0.5, 0.5, -0.5, 0.5] } as const;
const ball = sphere(1.5, { segments: 8 });
const mesh: Mesh = {
  ...ball,
  groups: [
    { start: 0, count: 24, material: 0 },
    { start: 24, count: ball.indices.length - 24, material: 1 },
  ],
};
const plain: Mesh = { ...mesh, groups: [{ start: 0, count: mesh.indices.length, material: 1 }] };
const object = (path: string, rest: Partial<SceneObject>): SceneObject => ({
  path,
  mesh: plain,
  motion: { kind: 'static', pose },
  lifetime: always,
  authoredIn: 'world',
  ...rest,
});

const wave = (k: number): Float32Array => plain.positions.map((x, i) => Math.fround(x * (1 + 0.1 * Math.sin(i + k))));
const poses = Float64Array.from([0, 0, 0, 0, 0, 0, 1, 0.1, 0.2, 0.3, 0, 0.6, 0, 0.8, 1e6, 0, 0, 0, 1, 0, 0]);
const points = [wave(0), wave(1), wave(2)];

/** A scene with everything a scene can contain. */
const scene: Scene = {
  name: 'scene.usda',
  upAxis: 'Z',
  metersPerUnit: 1,
  timeCodesPerSecond: 24,
  startTime: 0,
  endTime: 2,
  objects: [
    object('/World/Static', { mesh }),
    object('/World/Static/Nested', {
      authoredIn: 'rest',
      motion: { kind: 'uniform', pose, velocity: [1, 2, -3.3] },
      lifetime: { birth: -1.5, death: 7 },
    }),
    object('/World/Rocket', { motion: { kind: 'hyperbolic', pose, properAcceleration: [0, 0, 9.81], t0: 0.25 } }),
    object('/World/Sampled', { motion: { kind: 'sampled', times: Float64Array.of(0, 0.75, 2), poses } }),
    object('/World/Waving', {
      mesh: { ...plain, positions: points[0] },
      motion: {
        kind: 'sampled-points',
        times: Float64Array.of(0, 0.5, 2),
        origin: [1e5, 0, 0.5],
        points,
        normals: [plain.normals, plain.normals, plain.normals],
      },
    }),
    object('/World/Colored', { mesh: { ...plain, colors: plain.positions.map((x) => Math.abs(x) / 1.5) } }),
  ],
  materials: [
    {
      name: '/Looks/Plain',
      baseColor: [0.25, 0.5, 0.75],
      emissive: [0, 0.5, 0],
      roughness: 0.25,
      metallic: 1,
      opacity: 0.5,
      opacityThreshold: 0,
    },
    {
      name: 'Wood grain',
      baseColor: [1, 1, 1],
      baseColorTexture: texture('a/wood.jpg', 255, 7),
      emissive: [2, 2, 2],
      emissiveTexture: texture('b/wood.jpg', 255, 11),
      roughness: 0.5,
      metallic: 0,
      opacity: 1,
      opacityThreshold: 0,
      ior: 1.75,
      clearcoat: { factor: 0.5, roughness: 0.25 },
    },
    {
      name: '/Looks/White',
      baseColor: [1, 1, 1],
      emissive: [0, 0, 0],
      roughness: 0.5,
      metallic: 0,
      opacity: 1,
      opacityThreshold: 0,
    },
    {
      name: '/Looks/Leaf',
      baseColor: [1, 1, 1],
      baseColorTexture: texture('leaf.png', 64, 3),
      emissive: [0, 0, 0],
      roughness: 0.5,
      metallic: 0,
      opacity: 1,
      opacityThreshold: 0.5,
    },
  ],
  lights: [
    {
      kind: 'distant',
      path: '/Lights/Sun',
      direction: [0.6, 0, -0.8],
      color: [3, 2.5, 2],
      angle: 0.02,
      spectrum: { kind: 'thermal', temperature: 5772.5 },
    },
    {
      kind: 'sphere',
      path: '/Lights/Lamp',
      motion: { kind: 'uniform', pose, velocity: [1, 2, 3] },
      lifetime: { birth: -1, death: Number.POSITIVE_INFINITY },
      radius: 0.25,
      color: [10, 10, 10],
    },
    {
      kind: 'sphere',
      path: '/Lights/Swung',
      motion: {
        kind: 'sampled',
        times: Float64Array.of(0, 0.75),
        poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 4, 0, 0.5, 0, 0, 0, 1),
      },
      lifetime: { birth: Number.NEGATIVE_INFINITY, death: 3 },
      radius: 0,
      color: [1, 2, 3],
    },
    {
      kind: 'dome',
      path: '/Lights/Evening',
      color: [0.25, 0.5, 1],
      gradient: { horizon: [1, 0.5, 0.25], ground: [0.125, 0.125, 0] },
    },
    {
      kind: 'dome',
      path: '/Lights/Sky',
      color: [0.5, 0.5, 1],
      texture: texture('sky.png', 255, 5),
      orientation: pose.orientation,
    },
  ],
  cameras: [
    { path: '/Cameras/Main', motion: { kind: 'static', pose }, fovY: 0.8 },
    {
      path: '/Cameras/Drone',
      motion: {
        kind: 'sampled',
        times: Float64Array.of(0, 1),
        poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 0, 1),
      },
      fovY: 1.2,
    },
  ],
  hints: {
    speedOfLight: 10,
    title: 'All "things"',
    lookFor: 'Everything.\nAnd more.',
    beta: [0.1, 0, -0.2],
    openAt: 1.5,
  },
  diagnostics: [],
};
const withColors: Scene = {
  ...scene,
  objects: scene.objects.map((o) =>
    o.mesh.colors ? { ...o, mesh: { ...o.mesh, groups: [{ ...o.mesh.groups[0], material: 2 }] } } : o,
  ),
};
const leafy: Scene = {
  ...scene,
  objects: [object('/Leaf', { mesh: { ...plain, groups: [{ ...plain.groups[0], material: 3 }] } })],
};

const reread = (s: Scene): Promise<Scene> => readUsd(memorySource({ 'scene.usdz': writeUsdz(s) }), 'scene.usdz');

describe('a written scene is read back unchanged', async () => {
  const back = await reread(withColors);

  it('without diagnostics', () => {
    expect(back.diagnostics.filter(({ code }) => code !== 'usd.between-samples')).toEqual([]);
  });

  it.each(withColors.objects.map((o) => [o.path, o] as const))('%s', (path, before) => {
    const after = back.objects.find((o) => o.path === path)!;
    expect(after.mesh.positions).toEqual(before.mesh.positions);
    expect(after.mesh.indices).toEqual(before.mesh.indices);
    expect(after.mesh.uvs).toEqual(before.mesh.uvs);
    expect(after.mesh.colors).toEqual(before.mesh.colors);
    expect(Math.max(...after.mesh.normals.map((x, i) => Math.abs(x - before.mesh.normals[i])))).toBeLessThan(1e-6);
    expect(after.mesh.groups.map((g) => g.count)).toEqual(before.mesh.groups.map((g) => g.count));
    expect([after.lifetime, after.authoredIn]).toEqual([before.lifetime, before.authoredIn]);
    expect(after.motion.kind).toBe(before.motion.kind);
  });

  it('motions', () => {
    const motion = (path: string) => back.objects.find((o) => o.path === path)!.motion;
    const near = (values: ArrayLike<number>) => Array.from(values, (x) => expect.closeTo(x, 9));
    expect(motion('/World/Static/Nested')).toEqual({
      kind: 'uniform',
      velocity: [1, 2, -3.3],
      pose: { position: pose.position, orientation: near(pose.orientation) },
    });
    expect(motion('/World/Rocket')).toMatchObject({ properAcceleration: [0, 0, 9.81], t0: 0.25 });
    const waving = motion('/World/Waving');
    if (waving.kind !== 'sampled-points') throw new Error(waving.kind);
    expect(waving.times).toEqual(Float64Array.of(0, 0.5, 2));
    waving.times.forEach((_, k) => {
      const p = pointsAt(waving, k);
      for (let i = 0; i < p.length; i++)
        expect(p[i] + waving.origin[i % 3] - [1e5, 0, 0.5][i % 3]).toBeCloseTo(points[k][i], 5);
    });
  });

  it('sampled poses, with more samples where they rotate', () => {
    const { motion } = back.objects.find((o) => o.path === '/World/Sampled')!;
    if (motion.kind !== 'sampled') throw new Error(motion.kind);
    [0, 0.75, 2].forEach((t, i) => {
      const k = motion.times.indexOf(t);
      const [after, before] = [motion.poses.subarray(7 * k, 7 * k + 7), poses.subarray(7 * i, 7 * i + 7)];
      expect(Array.from(after.subarray(0, 3))).toEqual(Array.from(before.subarray(0, 3)));
      const cosine = [3, 4, 5, 6].reduce((n, j) => n + after[j] * before[j], 0);
      expect(Math.abs(cosine)).toBeCloseTo(1, 12);
    });
  });

  it('materials and textures', () => {
    const used = (name: string) => back.materials.find((m) => m.name === name)!;
    expect(used('/Looks/Plain')).toEqual(scene.materials[0]);
    expect(used('/Materials/Wood_grain')).toMatchObject({
      baseColorTexture: { ...scene.materials[1].baseColorTexture, name: 'textures/wood.png' },
      emissive: [2, 2, 2],
      emissiveTexture: { data: scene.materials[1].emissiveTexture!.data },
    });
  });

  it('a cut-out texture', async () => {
    expect((await reread(leafy)).materials[0]).toMatchObject({
      ...scene.materials[3],
      baseColorTexture: { data: scene.materials[3].baseColorTexture!.data },
    });
  });

  it('scalar textures, and reflectance of invisible light', async () => {
    const map = { ...texture('finish.png', 255, 13), colorSpace: 'linear' } as const;
    const material: Material = {
      ...scene.materials[2],
      name: '/Looks/Brick',
      uv: 0.125,
      ir: 0.75,
      emissionTemperature: 2400,
      normalTexture: { texture: { ...map, data: map.data.slice() }, strength: [0.5, -0.25] },
      roughnessTexture: { texture: map, channel: 1, scale: 0.5, bias: 0.25 },
      metallicTexture: { texture: map, channel: 2, scale: 1, bias: 0 },
      occlusionTexture: { texture: map, channel: 0, scale: 0.75, bias: 0.25 },
      irTexture: { texture: map, channel: 3, scale: 0.5, bias: 0.125 },
    };
    const [back] = (await reread({ ...leafy, materials: scene.materials.with(3, material) })).materials;
    const { normalTexture, roughnessTexture, metallicTexture, occlusionTexture, irTexture } = material;
    const named = (t: Texture | undefined, name: string) => ({ ...t, name: `textures/${name}.png` });
    expect(back).toMatchObject({
      uv: 0.125,
      ir: expect.closeTo(0.625, 6),
      emissionTemperature: 2400,
      normalTexture: { ...normalTexture, texture: named(normalTexture?.texture, 'finish') },
      roughnessTexture: { ...roughnessTexture, texture: named(roughnessTexture?.texture, 'finish_1') },
      metallicTexture: { ...metallicTexture, texture: named(metallicTexture?.texture, 'finish_1') },
      occlusionTexture: { ...occlusionTexture, texture: named(occlusionTexture?.texture, 'finish_1') },
      irTexture: { ...irTexture, texture: named(irTexture?.texture, 'finish_1') },
    });
  });

  it('a dome of radiance, as an EXR beside the text', async () => {
    const halves = Uint16Array.from([0.5, 2, 4000, 1, 0, 65504, 7, 1], toHalf);
    const sky = { ...texture('sky.hdr', 255, 1), width: 2, height: 1, data: halves, colorSpace: 'linear' } as const;
    const lights = [{ kind: 'dome', path: '/Sky', color: [1, 1, 1], texture: sky }] as const;
    expect([...writeTextures({ ...leafy, lights }).keys()]).toContain('textures/sky.exr');
    expect((await reread({ ...leafy, lights })).lights).toMatchObject([{ texture: { width: 2, data: halves } }]);
  });

  it('a spectrum without a name, as a table beside the text', async () => {
    const spectrum = { kind: 'sampled', first: 4e-7, step: 1e-8, values: [0.25, 1, 3.5] } as const;
    const light = { kind: 'distant', direction: [0, 0, -1], color: [1, 1, 1], spectrum } as const;
    const lights = ['/A', '/B'].map((path) => ({ ...light, path }));
    expect([...writeTextures({ ...leafy, lights }).keys()]).toContain('spectra/spectrum.csv');
    const [a, b] = (await reread({ ...leafy, lights })).lights as readonly DistantLight[];
    expect(a.spectrum).toMatchObject({ kind: 'sampled', first: expect.closeTo(4e-7, 15), values: spectrum.values });
    expect(b.spectrum).toBe(a.spectrum);
  });

  it('a measured reflectance, as a table beside the text', async () => {
    const reflectance = { first: 4e-7, step: 1e-8, values: [0.25, 1, 0.5] } as const;
    const materials = leafy.materials.map(({ baseColorTexture: _, ...bare }) => ({ ...bare, reflectance }));
    const scene = { ...leafy, materials };
    expect([...writeTextures(scene).keys()]).toContain('spectra/reflectance.csv');
    const back = (await reread(scene)).materials.find((m) => m.reflectance);
    expect(back?.reflectance).toMatchObject({ first: expect.closeTo(4e-7, 15), values: reflectance.values });
  });

  it('lights, cameras, hints and times', () => {
    expect(back.lights).toMatchObject([
      {
        kind: 'distant',
        direction: [0.6, 0, -0.8].map((x) => expect.closeTo(x, 12)),
        color: [3, 2.5, 2],
        angle: expect.closeTo(0.02, 7),
        spectrum: { kind: 'thermal', temperature: 5772.5 },
      },
      ...scene.lights.slice(1, 3),
      scene.lights.at(-2),
      { kind: 'dome', color: [0.5, 0.5, 1], orientation: pose.orientation.map((x) => expect.closeTo(x, 12)) },
    ]);
    expect(back.cameras.map((c) => c.fovY)).toEqual([expect.closeTo(0.8, 6), expect.closeTo(1.2, 6)]);
    expect(back.cameras.map((c) => c.motion.kind)).toEqual(['static', 'sampled']);
    expect(back.hints).toEqual(scene.hints);
    expect(back).toMatchObject({ startTime: 0, endTime: 2, upAxis: 'Z', metersPerUnit: 1, timeCodesPerSecond: 24 });
  });
});

describe('binary USD', () => {
  it('has the layer of the text, to the last bit', () => {
    const text = parseLayer(new TextEncoder().encode(writeUsda(scene)), 'scene.usda');
    expect(readCrate(writeUsdc(scene), 'scene.usda')).toEqual(text);
  });

  it('is the first file of a package, as usdzip has it', () => {
    const { files, layer } = openPackage(writeUsdz(scene), 'x');
    expect([...files.keys()][0]).toBe('scene.usdc');
    expect(layer).toBe('scene.usdc');
    expect(contentBytes(files.get(layer)!)).toEqual(writeUsdc(scene));
  });
});

describe('the written files', () => {
  it('are deterministic', () => {
    expect(writeUsdz(scene)).toEqual(writeUsdz(scene));
  });

  it('have distinct names for textures of the same name', () => {
    expect([...writeTextures(scene).keys()]).toEqual([
      'textures/wood.png',
      'textures/wood_1.png',
      'textures/leaf.png',
      'textures/sky.png',
    ]);
  });

  it('are aligned to 64 bytes within a usdz', () => {
    const bytes = writeUsdz(scene);
    for (const file of openPackage(bytes, 'x').files.values())
      expect((contentBytes(file).byteOffset - bytes.byteOffset) % 64).toBe(0);
  });

  it('have distinct names for objects of the same name', () => {
    const twice: Scene = { ...scene, objects: [object('/A b', {}), object('/A b', {})] };
    expect(writeUsda(twice).match(/def Mesh "\w+"/g)).toEqual(['def Mesh "A_b"', 'def Mesh "A_b_1"']);
  });

  it('have distinct names for the parts of a mesh and what lies below it', async () => {
    const inside: Scene = {
      ...scene,
      objects: [object('/A', { mesh }), object('/A/Part0', {})],
      lights: [],
      cameras: [],
    };
    const text = writeUsda(inside);
    expect(text.match(/def GeomSubset "\w+"/g)).toEqual(['def GeomSubset "Part0_1"', 'def GeomSubset "Part1"']);
    const { objects } = await readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda');
    expect(objects.map(({ path, mesh: { groups } }) => [path, groups.length])).toEqual([
      ['/A', 2],
      ['/A/Part0', 1],
    ]);
  });

  it('have lengths in the scene’s original units', async () => {
    const inches: Scene = { ...scene, metersPerUnit: 0.0254 };
    const { mesh: after } = (
      await readUsd(memorySource({ 'a.usda': new TextEncoder().encode(writeUsda(inches)) }), 'a.usda')
    ).objects[0];
    expect(after.positions.map((x, i) => x - mesh.positions[i]).every((d) => Math.abs(d) < 3e-7)).toBe(true);
  });
});

describe('text of numbers and names', () => {
  it('is short and round-trips f32', () => {
    const bits = new Uint32Array(1);
    const value = new Float32Array(bits.buffer);
    for (let i = 1; i < 4000; i++) {
      bits[0] = Math.imul(i, 2654435761) & 0xff7fffff;
      const text = floatText(value[0]);
      expect(Object.is(Math.fround(Number(text)), value[0])).toBe(true);
    }
    expect([0.1, 1 / 3, 16777216, -0].map((x) => floatText(x))).toEqual(['0.1', '0.33333334', '16777216', '-0']);
  });

  it('is a valid identifier', () => {
    expect(['a b', '1x', '名', 'a.b', ''].map(primName)).toEqual(['a_b', '_1x', '名', 'a_b', '_']);
  });
});

it('writes readable text', async () => {
  const { objects } = scene;
  const small: Scene = {
    ...scene,
    objects: [
      {
        ...objects[2],
        mesh: {
          positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
          normals: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1),
          uvs: new Float32Array(6),
          indices: Uint32Array.of(0, 1, 2),
          groups: [{ start: 0, count: 3, material: 0 }],
          doubleSided: false,
        },
      },
    ],
    lights: [],
    cameras: [],
  };
  await expect(writeUsda(small)).toMatchFileSnapshot('../fixtures/written.usda');
});
