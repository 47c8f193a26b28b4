import { expect, it } from 'vitest';
import { skinnedScene } from '../../../tests/support/skinnedScene.ts';
import { distance } from '../../math/vec3.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { pointSamples, vertexPosition } from '../../scene/motion/motion.ts';
import { isBlended, normalsAt } from '../../scene/streaming/samplePoints.ts';
import type { Scene, SceneObject } from '../../scene/types.ts';
import { memorySource } from '../files/fileSource.ts';
import { openScene } from '../open.ts';
import { saveScene } from '../save.ts';

const C = 1e9;
/** A ten-thousandth of half the diagonal, twice as large where it is stretched; and scales in halves. */
const CLOSE = 1e-3;

const found = ({ objects }: Scene, path: string): SceneObject =>
  objects.find((object) => object.path === path || object.path === `${path}/Mesh`)!;

it.each([
  ['a.usda', 'Z', 0.01],
  ['a.usdc', 'Y', 1],
  ['a.usdz', 'Y', 1],
  ['a.glb', 'Y', 1],
  ['a.gltf', 'Y', 1],
] as const)('skins keep their joints and places in %s, up %s, units of %d m', async (name, upAxis, metersPerUnit) => {
  const scene = skinnedScene({ upAxis, metersPerUnit });
  const { files, diagnostics } = await saveScene(scene, name);
  expect(diagnostics.filter(({ code }) => code !== 'convert.times')).toEqual([]);
  const back = await openScene(memorySource(Object.fromEntries(files)), name, { chordTolerance: 1e-5 });
  expect(back.diagnostics).toEqual([]);
  expect(back.objects).toHaveLength(scene.objects.length);
  // glTF has no times before 0.
  const later = name.startsWith('a.gl') ? -scene.startTime : 0;
  for (const object of scene.objects) {
    const again = found(back, object.path);
    const [samples, read] = [pointSamples(object.motion), pointSamples(again.motion)];
    if (!samples || !isBlended(samples.points)) continue;
    expect(read && isBlended(read.points), object.path).toBe(true);
    if (!read || !isBlended(read.points)) return;
    expect(read.points.poses.tree.names).toEqual(expect.arrayContaining([...samples.points.poses.tree.names]));
    expect([...again.mesh.indices], object.path).toEqual([...object.mesh.indices]);
    for (let k = 0; k < samples.times.length; k += 7)
      for (let v = 0; v < object.mesh.positions.length / 3; v += 3) {
        const [p, q] = [
          vertexPosition(object, v, samples.times[k], C),
          vertexPosition(again, v, samples.times[k] + later, C),
        ];
        expect(distance(p, q), `${object.path}, vertex ${v} at ${samples.times[k]} s`).toBeLessThan(CLOSE);
      }
  }
});

it('normals stay across the surface', async () => {
  const scene = skinnedScene();
  for (const name of ['a.usdc', 'a.glb']) {
    const { files } = await saveScene(scene, name);
    const back = await openScene(memorySource(Object.fromEntries(files)), name, { chordTolerance: 1e-5 });
    for (const path of ['/Crowd/Arm', '/Crowd/Sleeve', '/Mirrored']) {
      const [before, after] = [found(scene, path), found(back, path)].map(
        ({ motion }) => normalsAt(pointSamples(motion)!, 0)!,
      );
      for (let v = 0; v < before.length / 3; v++)
        expect(distance(pointAt(before, v), pointAt(after, v)), `${name} ${path}`).toBeLessThan(2e-3);
    }
  }
});

it('keys are fewer than samples, and what is written is small', async () => {
  const scene = skinnedScene();
  const vertices = scene.objects.reduce((sum, { mesh }) => sum + mesh.positions.length / 3, 0);
  const asPoints = 24 * vertices * 241;
  for (const name of ['a.usdc', 'a.glb']) {
    const { files } = await saveScene(scene, name);
    const size = [...files.values()].reduce((sum, bytes) => sum + bytes.length, 0);
    expect(size, name).toBeLessThan(asPoints / 5);
  }
});

it('a written file that is read and written again is the same', async () => {
  const once = await saveScene(skinnedScene(), 'a.usdc');
  const read = async (files: ReadonlyMap<string, Uint8Array>) =>
    openScene(memorySource(Object.fromEntries(files)), 'a.usdc');
  const twice = await saveScene(await read(once.files), 'a.usdc');
  const thrice = await saveScene(await read(twice.files), 'a.usdc');
  const sizes = [once, twice, thrice].map(({ files }) =>
    [...files.values()].reduce((sum, bytes) => sum + bytes.length, 0),
  );
  expect(sizes[2] / sizes[1]).toBeLessThan(1.02);
  expect(sizes[1] / sizes[0]).toBeLessThan(1.2);
});
