import { type Document, WebIO } from '@gltf-transform/core';
import { MeshoptDecoder } from 'meshoptimizer';
import { type Mesh as ThreeMesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { describe, expect, it } from 'vitest';
import { GltfBuilder } from '../../../../tests/support/gltfBuilder.ts';
import { dracoGlb, meshoptGlb } from '../../../../tests/support/gltfCompress.ts';
import { distance, type Vec3 } from '../../../math/vec3.ts';
import { pointAt } from '../../../scene/mesh/polygons.ts';
import { sphere } from '../../../scene/mesh/primitives.ts';
import type { Mesh, Scene } from '../../../scene/types.ts';
import { memorySource } from '../../files/fileSource.ts';
import { readGltf } from '../index.ts';

/** A textured moving sphere. */
function ball(segments = 16): GltfBuilder {
  const kit = new GltfBuilder();
  const mesh = sphere(1, { segments });
  const primitive = kit
    .triangle([...mesh.positions])
    .setAttribute('NORMAL', kit.values('VEC3', [...mesh.normals]))
    .setAttribute('TEXCOORD_0', kit.values('VEC2', [...mesh.uvs]))
    .setIndices(kit.ints('SCALAR', [...mesh.indices]));
  const node = kit.meshNode('Ball', primitive);
  kit.scene.addChild(node);
  kit.animate(node, 'translation', [0, 1, 2], [0, 0, 0, 1, 2, 3, 0, 0, 5]);
  return kit;
}

const readGlb = (glb: Uint8Array): Promise<Scene> => readGltf(memorySource({ 'a.glb': glb }), 'a.glb');
const plain = (doc: Document): Promise<Uint8Array> => new WebIO().writeBinary(doc);

/** Corners of triangles in a canonical order. */
const corners = (mesh: Mesh): { p: Vec3; n: Vec3; uv: number[] }[][] => {
  const corner = (v: number) => ({
    p: pointAt(mesh.positions, v),
    n: pointAt(mesh.normals, v),
    uv: [...mesh.uvs.subarray(2 * v, 2 * v + 2)],
  });
  return Array.from({ length: mesh.indices.length / 3 }, (_, t) =>
    [0, 1, 2].map((k) => corner(mesh.indices[3 * t + k])),
  );
};

/** Greatest distance of corners from the best cyclic order of the corresponding triangle. */
function worstOff(got: Mesh, wanted: Mesh): { position: number; normal: number; uv: number } {
  const all = corners(wanted);
  const worst = { position: 0, normal: 0, uv: 0 };
  for (const triangle of corners(got)) {
    const turns = all.flatMap((w) => [w, [w[1], w[2], w[0]], [w[2], w[0], w[1]]]);
    const off = (w: typeof triangle): number =>
      Math.max(
        ...triangle.map((c, k) => distance(c.p, w[k].p) + Math.hypot(c.uv[0] - w[k].uv[0], c.uv[1] - w[k].uv[1])),
      );
    const best = turns.reduce((a, b) => (off(a) <= off(b) ? a : b));
    triangle.forEach((c, k) => {
      worst.position = Math.max(worst.position, distance(c.p, best[k].p));
      worst.normal = Math.max(worst.normal, distance(c.n, best[k].n));
      worst.uv = Math.max(worst.uv, Math.abs(c.uv[0] - best[k].uv[0]), Math.abs(c.uv[1] - best[k].uv[1]));
    });
  }
  return worst;
}

/** Triangles rotated so that each begins with its lowest vertex index. */
const lowestFirst = ({ indices }: Mesh): number[][] =>
  Array.from({ length: indices.length / 3 }, (_, t) => {
    const [a, b, c] = indices.subarray(3 * t, 3 * t + 3);
    const low = Math.min(a, b, c);
    return low === a ? [a, b, c] : low === b ? [b, c, a] : [c, a, b];
  });

describe('compressed glTF', () => {
  it.each(['edgebreaker', 'sequential'] as const)('Draco, %s: the mesh up to quantisation', async (method) => {
    const wanted = (await readGlb(await plain(ball().doc))).objects[0];
    const glb = await dracoGlb(ball().doc, method);
    const scene = await readGlb(glb);
    const [got] = scene.objects;
    expect(got.mesh.indices.length).toBe(wanted.mesh.indices.length);
    const worst = worstOff(got.mesh, wanted.mesh);
    // 16 bits over 2 m: half a step along each axis; normals and uvs have 14 bits.
    expect(worst.position).toBeLessThan((Math.sqrt(3) * 2) / 2 ** 16);
    expect(worst.normal).toBeLessThan(4 / 2 ** 14);
    expect(worst.uv).toBeLessThan(1 / 2 ** 14);
    expect(got.motion).toEqual(wanted.motion);
    expect(scene.diagnostics).toEqual([]);
  });

  it('Draco: primitives may share data, and some attributes may be uncompressed', async () => {
    const kit = new GltfBuilder();
    const colors = kit.doc
      .createAccessor()
      .setType('VEC3')
      .setArray(Uint8Array.from([255, 0, 0, 0, 255, 0, 0, 0, 255]));
    const triangle = kit.triangle().setAttribute('COLOR_0', colors.setNormalized(true));
    triangle.setIndices(kit.ints('SCALAR', [0, 1, 2]));
    kit.scene.addChild(kit.meshNode('A', triangle, triangle.clone()));
    const [object] = (await readGlb(await dracoGlb(kit.doc, 'sequential'))).objects;
    expect([...object.mesh.colors!]).toEqual([1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
  });

  it('Draco: primitives with data of their own may share accessors', async () => {
    const kit = new GltfBuilder();
    const place = [0, 0, 5];
    const first = kit.triangle().setIndices(kit.ints('SCALAR', [0, 1, 2]));
    const corners = [...place, 2, 0, 5, 2, 2, 5, 0, 2, 5];
    const second = kit.triangle(corners).setIndices(kit.ints('SCALAR', [0, 1, 2, 0, 2, 3]));
    kit.scene.addChild(kit.meshNode('A', first, second));
    const { json, binary } = partsOf(await dracoGlb(kit.doc, 'sequential'));
    const [a, b] = json.meshes[0]!.primitives;
    // As glTF-pipeline writes them: both name the accessors of the first, whose counts are those of one of them.
    Object.assign(b!, { attributes: a!.attributes, indices: a!.indices });
    json.buffers = [{ ...json.buffers[0]!, uri: 'a.bin' }];
    const files = memorySource({ 'a.gltf': encode(json), 'a.bin': binary });
    const { mesh } = (await readGltf(files, 'a.gltf')).objects[0]!;
    const used = [...mesh.indices].map((v) => pointAt(mesh.positions, v).map((x) => Math.round(x * 1e3) / 1e3));
    expect(used.slice(0, 3)).toEqual([
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ]);
    expect(used.slice(3)).toEqual([place, [2, 0, 5], [2, 2, 5], place, [2, 2, 5], [0, 2, 5]]);
  });

  it('Draco: a regular grid, the best compressible mesh, is within the limits', async () => {
    const kit = new GltfBuilder();
    const n = 150;
    const at = (i: number, j: number): number => i * (n + 1) + j;
    const points = Array.from({ length: (n + 1) ** 2 }, (_, v) => [Math.floor(v / (n + 1)), v % (n + 1), 0]).flat();
    const squares = Array.from({ length: n * n }, (_, s) => [Math.floor(s / n), s % n]);
    const indices = squares.flatMap(([i, j]) => [
      at(i, j),
      at(i, j + 1),
      at(i + 1, j),
      at(i, j + 1),
      at(i + 1, j + 1),
      at(i + 1, j),
    ]);
    kit.scene.addChild(kit.meshNode('Grid', kit.triangle(points).setIndices(kit.ints('SCALAR', indices))));
    const glb = await dracoGlb(kit.doc, 'edgebreaker', 8);
    const { mesh } = (await readGlb(glb)).objects[0];
    expect([mesh.indices.length / 3, glb.length < 20_000]).toEqual([2 * n * n, true]);
  });

  it('meshopt without filters: bit-exact, except for the first corner of triangles', async () => {
    const [wanted] = (await readGlb(await plain(ball().doc))).objects;
    const scene = await readGlb(await meshoptGlb(ball().doc, 'quantize'));
    const [got] = scene.objects;
    expect({ ...got.mesh, indices: lowestFirst(got.mesh) }).toEqual({
      ...wanted.mesh,
      indices: lowestFirst(wanted.mesh),
    });
    expect(got.motion).toEqual(wanted.motion);
    expect(scene.diagnostics).toEqual([]);
  });

  it('meshopt with filters: agrees with three.js', async () => {
    const glb = await meshoptGlb(ball().doc, 'filter');
    await MeshoptDecoder.ready;
    const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
    const gltf = await loader.parseAsync(glb.slice().buffer, '');
    const three = gltf.scene.getObjectByName('Ball') as ThreeMesh;
    const { mesh } = (await readGlb(glb)).objects[0];
    const at = new Vector3();
    const { position, normal } = three.geometry.attributes;
    expect(mesh.positions.length).toBe(3 * position.count);
    expect([...mesh.indices]).toEqual([...three.geometry.index!.array]);
    for (let v = 0; v < position.count; v++) {
      expect(pointAt(mesh.positions, v)).toEqual([position.getX(v), position.getY(v), position.getZ(v)]);
      const n = at.fromBufferAttribute(normal, v).normalize();
      expect(distance(pointAt(mesh.normals, v), [n.x, n.y, n.z])).toBeLessThan(1e-6);
    }
  });

  it('reads meshopt fallback buffers without data', async () => {
    const glb = await meshoptGlb(ball().doc, 'quantize');
    const { json, binary } = partsOf(glb);
    for (const buffer of json.buffers) buffer.uri = buffer.extensions ? 'not-there.bin' : 'a.bin';
    const files = memorySource({ 'a.gltf': encode(json), 'a.bin': binary });
    expect((await readGltf(files, 'a.gltf')).objects[0]).toEqual((await readGlb(glb)).objects[0]);
  });

  it('reports errors of compressed data', async () => {
    const message = async (json: object, binary: Uint8Array): Promise<string> =>
      readGltf(memorySource({ 'a.gltf': encode(json), 'a.bin': binary }), 'a.gltf').then(
        () => 'read',
        (error: Error) => error.message,
      );
    const draco = partsOf(await dracoGlb(ball().doc, 'edgebreaker'));
    draco.json.buffers = [{ ...draco.json.buffers[0], uri: 'a.bin' }];
    const view = draco.json.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.bufferView;
    const at = draco.json.bufferViews[view].byteOffset ?? 0;
    expect(await message(draco.json, draco.binary)).toBe('read');
    expect(await message(draco.json, draco.binary.with(at, 1))).toBe(
      'a.gltf: mesh Ball: its compressed data does not begin with DRACO; export it again, or without compression',
    );
    expect(await message(draco.json, draco.binary.with(at + 5, 9))).toContain('has bitstream version 9.2');
    const bomb = draco.binary.slice();
    bomb.set([255, 255, 255, 255, 15], at + 13);
    expect(await message(draco.json, bomb)).toMatch(/claims \d+ triangles in \d+ bytes/);
    draco.json.accessors[0].count++;
    expect(await message(draco.json, draco.binary)).toMatch(/holds \d+ values for accessor 0, which has/);

    const meshopt = partsOf(await meshoptGlb(ball().doc, 'quantize'));
    meshopt.json.buffers[0].uri = 'a.bin';
    expect(await message(meshopt.json, meshopt.binary)).toBe('read');
    const part = meshopt.json.bufferViews[0].extensions.EXT_meshopt_compression;
    part.count = 3e9;
    expect(await message(meshopt.json, meshopt.binary)).toMatch(/bufferView 0: .* claims 3000000000 elements in/);
    part.buffer = 7;
    expect(await message(meshopt.json, meshopt.binary)).toContain('refers to buffer 7');
  });
});

interface PackedJson {
  buffers: { uri?: string; extensions?: object }[];
  bufferViews: {
    byteOffset?: number;
    extensions: { EXT_meshopt_compression: { count: number; buffer: number } };
  }[];
  accessors: { count: number }[];
  meshes: {
    primitives: {
      attributes: object;
      indices: number;
      extensions: { KHR_draco_mesh_compression: { bufferView: number } };
    }[];
  }[];
}
const encode = (json: object): Uint8Array => new TextEncoder().encode(JSON.stringify(json));
function partsOf(glb: Uint8Array): { json: PackedJson; binary: Uint8Array } {
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length))) as PackedJson;
  return { json, binary: glb.slice(28 + length) };
}
