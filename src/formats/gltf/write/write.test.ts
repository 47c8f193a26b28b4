import fc from 'fast-check';
import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { openInThree } from '../../../../tests/support/threeViewer.ts';
import { fromAxisAngle } from '../../../math/quat.ts';
import { distance, type Vec3 } from '../../../math/vec3.ts';
import { inEnglish } from '../../../messages/message.ts';
import { FOREVER, makeMaterial, makeObject, makeScene, restingAt } from '../../../scene/defaults.ts';
import { projectedArea } from '../../../scene/lights/lightKinds.ts';
import { box } from '../../../scene/mesh/primitives.ts';
import { vertexPosition } from '../../../scene/motion/motion.ts';
import { pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { Material, Motion, Scene, SceneObject, Texture, TextureChannel } from '../../../scene/types.ts';
import { memorySource } from '../../files/fileSource.ts';
import { readUsd } from '../../usd/read.ts';
import { writeUsda } from '../../usd/write/writeUsd.ts';
import { readGltf } from '../read/read.ts';
import { writeGltf } from './write.ts';

/** Far above every speed here [m/s]. */
const C = 1e9;
const cube = box([1, 2, 3]);

const number = fc.double({ min: -50, max: 50, noNaN: true });
const vector = fc.tuple(number, number, number);
const turn = fc
  .tuple(vector, fc.double({ min: -2, max: 2, noNaN: true }))
  .map(([axis, angle]) => fromAxisAngle(Math.hypot(...axis) > 1e-3 ? axis : [0, 0, 1], angle));
/** Distinct multiples of 2⁻⁶ s, which are exact in f32. */
const times = fc.uniqueArray(fc.integer({ min: -64, max: 640 }), { minLength: 2, maxLength: 6 }).map((list) =>
  Float64Array.from(
    list.sort((a, b) => a - b),
    (n) => n / 64,
  ),
);
const still = fc
  .tuple(vector, turn)
  .map(([position, orientation]): Motion => ({ kind: 'static', pose: { position, orientation } }));
const rigid = times.chain((at) =>
  fc.array(fc.tuple(vector, turn), { minLength: at.length, maxLength: at.length }).map(
    (poses): Motion => ({
      kind: 'sampled',
      times: at,
      poses: Float64Array.from(poses.flat(2)),
    }),
  ),
);
const bending = fc
  .tuple(times, vector, fc.double({ min: 0.1, max: 2, noNaN: true }))
  .map(([at, origin, size]): Motion => {
    const points = Array.from(at, (_, k) => cube.positions.map((x, i) => x * (1 + size * Math.sin(i * (k + 1)))));
    return { kind: 'sampled-points', times: at, origin, points, normals: points.map(() => cube.normals) };
  });
const scenes = fc
  .tuple(
    fc.constantFrom('Y' as const, 'Z' as const),
    fc.array(fc.oneof(still, rigid, bending), { minLength: 1, maxLength: 4 }),
  )
  .map(
    ([upAxis, motions]): Scene =>
      makeScene({
        name: 'any',
        upAxis,
        endTime: 10,
        // Some nested: a glTF transform moves its descendants.
        objects: motions.map((motion, i) =>
          makeObject({ path: i % 2 ? `/World/A${i - 1}/B` : `/World/A${i}`, mesh: meshOf(motion), motion }),
        ),
      }),
  );
const meshOf = (motion: Motion) =>
  motion.kind === 'sampled-points' ? { ...cube, positions: pointsAt(motion, 0) } : cube;

const up = ({ upAxis }: Scene, [x, y, z]: Vec3): Vec3 => (upAxis === 'Y' ? [x, y, z] : [x, z, -y]);
const written = async (scene: Scene, name = 'a.glb') => {
  const { files, diagnostics } = await writeGltf(scene, name);
  return { source: memorySource(Object.fromEntries(files)), files, diagnostics };
};
/** Times of all samples, and the shift of their times in glTF. */
function samplesOf(object: SceneObject): number[] {
  return 'times' in object.motion ? [...object.motion.times] : [0];
}
const shiftOf = (scene: Scene): number => -Math.min(0, ...scene.objects.flatMap(samplesOf));

/** Greatest displacement of a vertex over all samples. */
function worst(scene: Scene, at: (object: number, vertex: number, t: number) => Vec3): number {
  let most = 0;
  for (const [i, object] of scene.objects.entries())
    for (const t of samplesOf(object))
      for (let v = 0; v < object.mesh.positions.length / 3; v++)
        most = Math.max(most, distance(up(scene, vertexPosition(object, v, t, C)), at(i, v, t + shiftOf(scene))));
  return most;
}
/** Positions are up to 90 m, with a few roundings of f32. */
const F32 = 90 * 2 ** -22;

describe('a scene written as glTF', () => {
  it('is read back with every vertex in place, to f32', async () => {
    await fc.assert(
      fc.asyncProperty(scenes, async (scene) => {
        const { source } = await written(scene);
        const back = await readGltf(source, 'a.glb');
        expect(back.objects).toHaveLength(scene.objects.length);
        const order = scene.objects.map(
          ({ path }) => back.objects.find((o) => o.path === path || o.path === `${path}/Mesh`)!,
        );
        expect(worst(scene, (i, v, t) => vertexPosition(order[i], v, t, C))).toBeLessThan(F32);
      }),
      { numRuns: 40 },
    );
  });

  it('is the same for a scene from USD', async () => {
    await fc.assert(
      fc.asyncProperty(scenes, async (scene) => {
        const text = new TextEncoder().encode(writeUsda({ ...scene, metersPerUnit: 0.01 }));
        const usd = await readUsd(memorySource({ 'a.usda': text }), 'a.usda');
        const { source } = await written(usd);
        const back = await readGltf(source, 'a.glb');
        const order = usd.objects.map(
          ({ path }) => back.objects.find((o) => o.path === path || o.path === `${path}/Mesh`)!,
        );
        expect(worst(usd, (i, v, t) => vertexPosition(order[i], v, t, C))).toBeLessThan(F32);
      }),
      { numRuns: 20 },
    );
  });

  it('agrees with three.js', async () => {
    await fc.assert(
      fc.asyncProperty(scenes, async (scene) => {
        const { files } = await written(scene);
        const { meshes, showAt } = await openInThree(files.get('a.glb')!);
        // Vertices are matched by position: three.js renames objects with duplicate names.
        const end = Math.max(...scene.objects.flatMap(samplesOf)) + shiftOf(scene);
        let most = 0;
        for (const object of scene.objects)
          for (const t of samplesOf(object)) {
            const later = t + shiftOf(scene);
            // At exactly its end an action restarts.
            if (later >= end) continue;
            showAt(later);
            const vertex = object.mesh.positions.length / 3 - 1;
            const place = up(scene, vertexPosition(object, vertex, t, C));
            const off = meshes.map((mesh) => {
              const p = mesh.localToWorld(mesh.getVertexPosition(vertex, new Vector3()));
              return distance([p.x, p.y, p.z], place);
            });
            most = Math.max(most, Math.min(...off));
          }
        expect(most).toBeLessThan(4 * F32);
      }),
      { numRuns: 20 },
    );
  });

  it('preserves materials, textures, colours, cameras and lights, as one file or several', async () => {
    const texture = {
      name: 'maps/dot.png',
      width: 1,
      height: 1,
      data: Uint8Array.of(1, 2, 3, 128),
      colorSpace: 'srgb',
      filter: 'nearest',
      wrapS: 'clamp',
      wrapT: 'mirror',
    } as const;
    const materials = [
      makeMaterial({
        name: 'Lamp',
        baseColor: [0.25, 0.5, 1],
        emissive: [8, 4, 2],
        roughness: 0.25,
        metallic: 1,
        ior: 1.25,
      }),
      makeMaterial({ name: 'Leaf', baseColorTexture: texture, opacity: 0.5, opacityThreshold: 0.75 }),
    ];
    const groups = [
      { start: 0, count: 12, material: 0 },
      { start: 12, count: cube.indices.length - 12, material: 1 },
    ];
    const mesh = { ...cube, groups, doubleSided: true, colors: cube.positions.map((x) => Math.abs(x) / 4) };
    const pose = { position: [1, 2, 3], orientation: [0, 0.6, 0, 0.8] } as const;
    const scene = makeScene({
      name: 'all',
      materials,
      objects: [makeObject({ path: '/World/Cube', mesh })],
      cameras: [{ path: '/World/Eye', motion: { kind: 'static', pose }, fovY: 0.75 }],
      lights: [
        { kind: 'distant', path: '/Sun', direction: [0, -1, 0], color: [2, 1, 0.5] },
        { kind: 'dome', path: '/Sky', color: [1, 1, 1] },
      ],
    });
    for (const name of ['a.glb', 'a.gltf']) {
      const { source, files, diagnostics } = await written(scene, name);
      expect(files.keys().next().value).toBe(name);
      expect(diagnostics.map((d) => `${d.code} ${inEnglish(d.place)}`)).toEqual([`convert.light ${name}: /Sky`]);
      const back = await readGltf(source, name);
      expect(back.materials).toMatchObject([
        { ...materials[0], emissive: [8, 4, 2] },
        { ...materials[1], baseColorTexture: { ...texture, name: expect.stringMatching(/png|dot/) } },
      ]);
      expect(back.objects[0].mesh.doubleSided).toBe(true);
      expect(back.objects[0].mesh.indices).toHaveLength(mesh.indices.length);
      expect(Math.max(...back.objects[0].mesh.colors!)).toBe(Math.max(...mesh.colors));
      expect(back.cameras).toMatchObject([
        { path: '/World/Eye', fovY: 0.75, motion: { pose: { position: [1, 2, 3] } } },
      ]);
      expect(back.lights[0]).toMatchObject({ kind: 'distant', path: '/Sun', color: [2, 1, 0.5] });
      const [light] = back.lights;
      if (light.kind === 'distant') expect(distance(light.direction, [0, -1, 0])).toBeLessThan(1e-6);
    }
  });

  it('preserves scalar textures, and reflectance of invisible light', async () => {
    const map: Texture = {
      name: 'finish.png',
      width: 2,
      height: 1,
      data: Uint8Array.of(10, 100, 200, 255, 20, 60, 40, 255),
      colorSpace: 'linear',
      filter: 'linear',
      wrapS: 'repeat',
      wrapT: 'repeat',
    };
    const channel = (channel: 0 | 1 | 2, scale: number, bias: number): TextureChannel => ({
      texture: map,
      channel,
      scale,
      bias,
    });
    const material = makeMaterial({
      name: 'Brick',
      uv: 0.125,
      emissionTemperature: 2400,
      normalTexture: { texture: { ...map, data: map.data.slice() }, strength: [0.5, 0.5] },
      roughnessTexture: channel(1, 0.5, 0),
      metallicTexture: channel(2, 1, 0),
      occlusionTexture: channel(0, 0.25, 0.75),
      irTexture: channel(2, 0.5, 0.125),
    });
    const reread = async (m: Material): Promise<Material> => {
      const { source, diagnostics } = await written(
        makeScene({ name: 'a', materials: [m], objects: [makeObject({ path: '/A', mesh: cube })] }),
        'a.glb',
      );
      expect(diagnostics).toEqual([]);
      return (await readGltf(source, 'a.glb')).materials[0];
    };
    const layered = makeMaterial({
      name: 'Varnished',
      specular: {
        factor: 0.5,
        color: [3, 1, 0.5],
        colorTexture: { ...map, colorSpace: 'srgb', data: map.data.slice() },
      },
      clearcoat: {
        factor: 0.25 * (160 / 255),
        factorTexture: channel(0, 0.25, 0),
        roughness: 0.125,
        normalTexture: { texture: { ...map, data: map.data.slice() }, strength: [0.5, 0.5] },
      },
    });
    expect(await reread(layered)).toMatchObject({
      specular: { factor: 0.5, color: [3, 1, 0.5], colorTexture: { data: map.data, colorSpace: 'srgb' } },
      clearcoat: {
        factorTexture: { texture: { data: map.data }, channel: 0, scale: 0.25 },
        roughness: 0.125,
        normalTexture: { texture: { data: map.data }, strength: [0.5, 0.5] },
      },
    });
    const sheen = {
      color: [0.5, 0.25, 1],
      colorTexture: { ...map, colorSpace: 'srgb', data: map.data.slice() },
      roughness: 0.5,
    } as const;
    expect((await reread(makeMaterial({ name: 'Velvet', sheen }))).sheen).toMatchObject({
      color: sheen.color,
      colorTexture: { data: map.data, colorSpace: 'srgb' },
      roughness: 0.5,
    });
    const grooves = {
      strength: 0.5,
      rotation: 0.75,
      directionTexture: { ...map, data: map.data.slice() },
    } as const;
    expect((await reread(makeMaterial({ name: 'Brushed', anisotropy: grooves }))).anisotropy).toMatchObject({
      strength: 0.5,
      rotation: 0.75,
      directionTexture: { data: map.data, colorSpace: 'linear' },
    });
    const film = { factor: 0.5, ior: 1.25, thickness: [1e-7, 4e-7] } as const;
    expect((await reread(makeMaterial({ name: 'Soap', iridescence: film }))).iridescence).toMatchObject({
      ...film,
      thickness: film.thickness.map((x) => expect.closeTo(x, 12)),
    });
    const glass = {
      ior: 1.25,
      dispersion: 0.5,
      transmission: { factor: 0.5 * (160 / 255), factorTexture: channel(0, 0.5, 0) },
      volume: { thickness: 0.25, attenuationColor: [0.5, 0.25, 1], attenuationDistance: 2 },
    } as const;
    expect(await reread(makeMaterial({ name: 'Glass', ...glass }))).toMatchObject({
      ...glass,
      transmission: { factorTexture: { texture: { data: map.data }, channel: 0, scale: 0.5 } },
    });
    const unlit = { emissive: [0.5, 0.25, 1], baseColor: [0, 0, 0], ior: 1, unlit: true } as const;
    expect(await reread(makeMaterial({ name: 'Sign', ...unlit }))).toMatchObject(unlit);
    expect(await reread(material)).toMatchObject({
      uv: 0.125,
      emissionTemperature: 2400,
      normalTexture: { texture: { data: map.data, colorSpace: 'linear' }, strength: [0.5, 0.5] },
      roughness: expect.closeTo((0.5 * 80) / 255, 6),
      roughnessTexture: { texture: { data: map.data }, channel: 1, scale: 0.5 },
      metallicTexture: { channel: 2, scale: 1 },
      occlusionTexture: { texture: { data: map.data }, channel: 0, scale: 0.25, bias: 0.75 },
      ir: expect.closeTo(0.5 * (120 / 255) + 0.125, 6),
      irTexture: { texture: { data: map.data, colorSpace: 'linear' }, channel: 2, scale: 0.5, bias: 0.125 },
    });
    // Another channel, with a bias: converted, next to a constant.
    const { metallicTexture: _, ...rough } = material;
    const baked = await reread({
      ...rough,
      metallic: 0.25,
      roughnessTexture: channel(0, 2, 0.2),
      occlusionTexture: channel(1, 0.5, 0.2),
    });
    const { texture, ...occlusion } = baked.occlusionTexture!;
    expect([texture.data[0], texture.data[4], occlusion]).toEqual([101, 81, { channel: 0, scale: 1, bias: 0 }]);
    const texels = baked.roughnessTexture!.texture.data;
    expect([texels[1], texels[5]]).toEqual([20 + 51, 40 + 51]);
    expect(baked).toMatchObject({ metallic: 0.25, metallicTexture: { channel: 2, scale: 0.25 } });
  });

  it('area lights become point lights of equal intensity from afar', async () => {
    const lamp = { motion: restingAt([1, 2, 3]), lifetime: FOREVER, color: [2, 2, 2] } as const;
    const shaping = { inner: 0.2, outer: 0.6, focus: 0 };
    const lights = [
      { ...lamp, kind: 'rect', path: '/Rect', width: 3, height: 2 },
      { ...lamp, kind: 'cylinder', path: '/Tube', radius: 0.5, length: 3 },
      { ...lamp, kind: 'sphere', path: '/Spot', radius: 0, shaping },
    ] as const;
    const { source, diagnostics } = await written(makeScene({ name: 'lamps', lights }), 'a.glb');
    expect(diagnostics.map((d) => inEnglish(d.message))).toEqual([
      'its shape, a rect, is lost: lights of glTF are points with a cone',
      'its shape, a cylinder, is lost: lights of glTF are points',
    ]);
    const back = (await readGltf(source, 'a.glb')).lights;
    const strength = back.map((light) => (light.kind === 'sphere' ? light.color[0] * projectedArea(light) : 0));
    expect(strength).toEqual([12, 6, 2].map((x) => expect.closeTo(x, 6)));
    expect(back).toMatchObject([{ shaping: { inner: 0 } }, {}, { shaping: { inner: 0.2, outer: 0.6 } }]);
  });

  it('the author’s viewing suggestions round-trip, on the axes and in the times of the file', async () => {
    const hints = {
      speedOfLight: 10,
      title: 'Street',
      lookFor: 'Houses turn',
      beta: [0.1, 0.8, 0.2],
      openAt: -2,
    } as const;
    const motion: Motion = {
      kind: 'sampled',
      times: Float64Array.of(-3, 1),
      poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 0, 1),
    };
    const scene = makeScene({
      name: 'a',
      upAxis: 'Z',
      hints,
      objects: [makeObject({ path: '/A', mesh: cube, motion })],
    });
    const { source, diagnostics } = await written(scene);
    expect((await readGltf(source, 'a.glb')).hints).toEqual({ ...hints, beta: [0.1, 0.2, -0.8], openAt: 1 });
    expect(diagnostics.map((d) => d.code)).toEqual(['convert.times']);
    const same = await written({ ...scene, upAxis: 'Y', startTime: 0, objects: [] }, 'a.gltf');
    expect((await readGltf(same.source, 'a.gltf')).hints).toEqual(hints);
  });

  it('invalid suggestions are ignored', async () => {
    const text = (slowlight: unknown) =>
      new TextEncoder().encode(JSON.stringify({ asset: { version: '2.0' }, scenes: [{ extras: { slowlight } }] }));
    const read = async (slowlight: unknown) =>
      (await readGltf(memorySource({ 'a.gltf': text(slowlight) }), 'a.gltf')).hints;
    expect(await read({ speedOfLight: -1, title: 3, beta: [0, 'x', 0], openAt: null, lookFor: 'here' })).toEqual({
      lookFor: 'here',
    });
    for (const none of [null, 7, 'text', [1, 2], {}]) expect(await read(none)).toEqual({});
  });

  it('may be empty', async () => {
    for (const name of ['a.glb', 'a.gltf'])
      expect((await readGltf((await written(makeScene({ name: 'nothing' }), name)).source, name)).objects).toEqual([]);
  });

  it('of pieces that take turns there is the one of the start', async () => {
    const piece = (n: number, birth: number, death: number) => ({
      ...makeObject({ path: `/Water/piece${n}`, mesh: { ...cube, doubleSided: n === 2 }, lifetime: { birth, death } }),
      pieceOf: '/Water',
    });
    const objects = [piece(1, Number.NEGATIVE_INFINITY, 0), piece(2, 0, 1), piece(3, 1, Number.POSITIVE_INFINITY)];
    const { source, diagnostics } = await written(makeScene({ name: 'water', objects }));
    expect(diagnostics.map((d) => `${d.severity} ${d.code} ${inEnglish(d.place)}`)).toEqual([
      'warning convert.lifetime a.glb: /Water',
    ]);
    expect((await readGltf(source, 'a.glb')).objects.map(({ mesh }) => mesh.doubleSided)).toEqual([true]);
  });

  it('reports lost content', async () => {
    const many = Array.from({ length: 200 }, () => cube.positions);
    const scene = makeScene({
      name: 'lossy',
      endTime: 2,
      hints: { speedOfLight: 10 },
      objects: [
        makeObject({
          path: '/Train',
          mesh: cube,
          authoredIn: 'rest',
          lifetime: { birth: -1, death: Number.POSITIVE_INFINITY },
          motion: { kind: 'uniform', pose: { position: [0, 0, 0], orientation: [0, 0, 0, 1] }, velocity: [6, 0, 0] },
        }),
        makeObject({
          path: '/Flag',
          mesh: cube,
          motion: { kind: 'sampled-points', times: Float64Array.from(many.keys()), origin: [0, 0, 0], points: many },
        }),
      ],
    });
    const { source, diagnostics } = await written(scene);
    expect(diagnostics.map((d) => `${d.severity} ${d.code} ${inEnglish(d.place)}`)).toEqual([
      'warning convert.lifetime a.glb: /Train',
      'warning convert.motion a.glb: /Train',
      'warning convert.points a.glb: /Flag',
    ]);
    const train = (await readGltf(source, 'a.glb')).objects[0];
    // At 0.6 c a length of 1 is one of 0.8.
    const xs = Array.from({ length: 8 }, (_, v) => vertexPosition(train, v, 1, 10)[0]);
    expect(Math.max(...xs) - Math.min(...xs)).toBeCloseTo(0.8, 6);
    expect((Math.max(...xs) + Math.min(...xs)) / 2).toBeCloseTo(6, 5);
  });
});
