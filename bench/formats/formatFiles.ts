import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { type Document, WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshGPUInstancing } from '@gltf-transform/extensions';
import { saveScene } from '../../src/formats/save.ts';
import { makeObject, makeScene } from '../../src/scene/defaults.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, Scene } from '../../src/scene/types.ts';
import { dracoGlb, meshoptGlb } from '../../tests/support/gltfCompress.ts';

const MILLION = 1_000_000;
const INSTANCES = 1000;
const INSTANCED = 10_000;

/** Writes the files that need no usd-core: a sphere of a million triangles as million.usda, .glb etc., and instances.glb. */
export async function writeFiles(folder: string): Promise<void> {
  const scene = sphereScene(MILLION);
  for (const kind of ['usda', 'glb', 'obj']) {
    const { files } = await saveScene(scene, `million.${kind}`);
    for (const [name, bytes] of files) writeFileSync(join(folder, name), bytes);
  }
  const { mesh } = scene.objects[0];
  writeFileSync(join(folder, 'million.ply'), ply(mesh));
  writeFileSync(join(folder, 'million.text.ply'), textPly(mesh));
  writeFileSync(join(folder, 'million.stl'), stl(mesh));
  const document = () => io().readBinary(readFileSync(join(folder, 'million.glb')));
  writeFileSync(join(folder, 'million.draco.glb'), await dracoGlb(await document(), 'edgebreaker', 14));
  writeFileSync(join(folder, 'million.meshopt.glb'), await meshoptGlb(await document(), 'quantize'));
  writeFileSync(join(folder, 'instances.glb'), await io().writeBinary(await instancedDocument()));
}

const io = (): WebIO => new WebIO().registerExtensions(ALL_EXTENSIONS);

/** A sphere of s segments and s/2 rings has s² − 2 s triangles. */
function sphereScene(triangles: number): Scene {
  const mesh = sphere(1, { segments: 2 * Math.round((1 + Math.sqrt(1 + triangles)) / 2) });
  const pose = { position: [0, 0, 0], orientation: [0, 0, 0, 1] } as const;
  return makeScene({ name: 'Ball', objects: [makeObject({ path: '/Ball', mesh, motion: { kind: 'static', pose } })] });
}

async function instancedDocument(): Promise<Document> {
  const { files } = await saveScene(sphereScene(INSTANCED), 'one.glb');
  const document = await io().readBinary(files.get('one.glb')!);
  const extension = document.createExtension(EXTMeshGPUInstancing).setRequired(true);
  const places = Float32Array.from({ length: 3 * INSTANCES }, (_, i) => 3 * (Math.floor(i / 3 / 10 ** (i % 3)) % 10));
  const accessor = document.createAccessor().setType('VEC3').setArray(places);
  const node = document
    .getRoot()
    .listNodes()
    .find((n) => n.getMesh())!;
  node.setExtension(
    'EXT_mesh_gpu_instancing',
    extension
      .createInstancedMesh()
      .setAttribute('TRANSLATION', accessor.setBuffer(document.getRoot().listBuffers()[0])),
  );
  return document;
}

const header = (format: string, { positions, indices }: Mesh): string => `ply
format ${format} 1.0
element vertex ${positions.length / 3}
${['x', 'y', 'z', 'nx', 'ny', 'nz'].map((name) => `property float ${name}`).join('\n')}
element face ${indices.length / 3}
property list uchar int vertex_indices
end_header
`;

function ply(mesh: Mesh): Uint8Array {
  const head = Buffer.from(header('binary_little_endian', mesh));
  const vertices = mesh.positions.length / 3;
  const triangles = mesh.indices.length / 3;
  const bytes = Buffer.alloc(head.length + 24 * vertices + 13 * triangles, head);
  for (let i = 0; i < 3 * vertices; i++) {
    const at = head.length + 24 * Math.floor(i / 3) + 4 * (i % 3);
    bytes.writeFloatLE(mesh.positions[i], at);
    bytes.writeFloatLE(mesh.normals[i], at + 12);
  }
  for (let t = 0; t < triangles; t++) {
    const at = head.length + 24 * vertices + 13 * t;
    bytes[at] = 3;
    for (let k = 0; k < 3; k++) bytes.writeInt32LE(mesh.indices[3 * t + k], at + 1 + 4 * k);
  }
  return bytes;
}

function textPly(mesh: Mesh): string {
  const triple = (from: Float32Array | Uint32Array, i: number): string => from.subarray(3 * i, 3 * i + 3).join(' ');
  const lines = (count: number, line: (i: number) => string): string =>
    Array.from({ length: count }, (_, i) => line(i)).join('\n');
  const vertices = lines(mesh.positions.length / 3, (v) => `${triple(mesh.positions, v)} ${triple(mesh.normals, v)}`);
  return `${header('ascii', mesh)}${vertices}\n${lines(mesh.indices.length / 3, (t) => `3 ${triple(mesh.indices, t)}`)}\n`;
}

function stl({ positions, indices }: Mesh): Uint8Array {
  const bytes = Buffer.alloc(84 + (50 * indices.length) / 3);
  bytes.writeUInt32LE(indices.length / 3, 80);
  // Normals stay zero: readers compute them from the winding order.
  for (let i = 0; i < indices.length; i++) {
    const at = 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3);
    for (let k = 0; k < 3; k++) bytes.writeFloatLE(positions[3 * indices[i] + k], at + 4 * k);
  }
  return bytes;
}
