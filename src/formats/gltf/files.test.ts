import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { boundingBox } from '../../scene/bounds/bounds.ts';
import type { Scene } from '../../scene/types.ts';
import type { FileSource } from '../files/fileSource.ts';
import { openScene } from '../open.ts';

/** Third-party files next to the repository, only on some machines. */
const root = fileURLToPath(new URL('../../../../shared/data/gltf/packages/', import.meta.url));
if (!existsSync(root)) console.warn('skipped: real glTF files; ../shared/data/gltf is not there');

const open = (path: string): Promise<Scene> => {
  const folder = join(root, dirname(path));
  const read: FileSource['read'] = async (name) =>
    existsSync(join(folder, name)) ? Uint8Array.from(readFileSync(join(folder, name))) : undefined;
  return openScene({ read }, path.slice(path.lastIndexOf('/') + 1));
};

describe.skipIf(!existsSync(root))('real glTF files', () => {
  it('a textured box: three files, a matrix that rotates Z up to Y up', async () => {
    const { objects, materials, diagnostics } = await open('core/test/in/BoxTextured_glTF/BoxTextured.gltf');
    expect(objects.map((o) => [o.path, o.mesh.indices.length / 3])).toEqual([['/Node0/Node1', 12]]);
    expect(boundingBox(objects[0].mesh.positions)).toEqual({ min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5] });
    expect(materials[0].baseColorTexture).toMatchObject({ width: 256, height: 256, name: 'CesiumLogoFlat.png' });
    expect(diagnostics).toEqual([]);
  });

  it('a small character in a GLB, with an embedded texture', async () => {
    const { objects, materials } = await open('cli/test/in/chr_knight.glb');
    expect(objects.length).toBe(1);
    expect(materials[0].baseColorTexture?.data.length).toBeGreaterThan(0);
  });

  it('a collection of shapes', async () => {
    const { objects } = await open('functions/test/in/ShapeCollection.glb');
    expect(objects.length).toBe(7);
    for (const { mesh } of objects) expect(mesh.positions.every(Number.isFinite)).toBe(true);
  });

  it('a sphere compressed by Draco', async () => {
    const { objects, diagnostics } = await open('functions/test/in/DenseSphere.glb');
    const { mesh } = objects[0];
    expect([mesh.indices.length / 3, diagnostics]).toEqual([30720, []]);
    // The accessor's bounds: the file has 16-bit integers that its node scales.
    const { min, max } = boundingBox(mesh.positions)!;
    const [x, y, z] = max.map((most, k) => most - min[k]);
    expect([x / y, z / y]).toEqual([expect.closeTo(32555 / 32767, 5), expect.closeTo(32575 / 32767, 5)]);
  });
});
