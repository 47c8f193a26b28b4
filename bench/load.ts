import { mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Document, NodeIO } from '@gltf-transform/core';
import { writeUsda } from '../src/formats/usd/write.ts';
import type { Mesh } from '../src/scene/types.ts';
import type { Bench } from './bench.ts';
import { inChild } from './inChild.ts';
import { ballScene } from './scenes.ts';

const TRIANGLES = 1_000_000;

export const load: Bench = {
  name: 'load',
  title: 'Loading a scene of a million triangles',
  about: 'From the file on disk to a scene in memory, in a process of its own; the peak is of that whole process.',
  async run() {
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-bench-'));
    try {
      const files = [writeUsd(folder), await writeGlb(folder)];
      const rows = files.map((file) => {
        const { seconds, peakBytes } = inChild<{ seconds: number; peakBytes: number }>('load', file);
        return [file.slice(file.lastIndexOf('.')), statSync(file).size / 2 ** 20, seconds, peakBytes / 2 ** 20];
      });
      return [{ columns: ['file', 'size [MiB]', 'time [s]', 'peak [MiB]'], rows }];
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
};

function writeUsd(folder: string): string {
  const file = join(folder, 'million.usda');
  writeFileSync(file, writeUsda(ballScene(TRIANGLES, 'static')));
  return file;
}

async function writeGlb(folder: string): Promise<string> {
  const file = join(folder, 'million.glb');
  const document = new Document();
  document.createBuffer();
  const scene = document.createScene();
  for (const { path, mesh } of ballScene(TRIANGLES, 'static').objects) {
    scene.addChild(document.createNode(path.slice(1)).setMesh(gltfMesh(document, mesh)));
  }
  writeFileSync(file, await new NodeIO().writeBinary(document));
  return file;
}

function gltfMesh(document: Document, mesh: Mesh) {
  const array = (type: 'VEC2' | 'VEC3' | 'SCALAR', data: Float32Array | Uint32Array) =>
    document.createAccessor().setType(type).setArray(data.slice());
  const primitive = document
    .createPrimitive()
    .setIndices(array('SCALAR', mesh.indices))
    .setAttribute('POSITION', array('VEC3', mesh.positions))
    .setAttribute('NORMAL', array('VEC3', mesh.normals))
    .setAttribute('TEXCOORD_0', array('VEC2', mesh.uvs));
  return document.createMesh().addPrimitive(primitive);
}
