import { Vector3 } from 'three';
import { expect, it } from 'vitest';
import { skinnedScene } from '../../../../tests/support/skinnedScene.ts';
import { openInThree } from '../../../../tests/support/threeViewer.ts';
import { distance } from '../../../math/vec3.ts';
import { pointSamples, vertexPosition } from '../../../scene/motion/motion.ts';
import { isBlended } from '../../../scene/streaming/samplePoints.ts';
import { writeGltf } from './write.ts';

it('three.js shows written skins where they are', async () => {
  const scene = skinnedScene({ upAxis: 'Y' });
  const { files } = await writeGltf(scene, 'a.glb');
  const { meshes, showAt } = await openInThree(files.get('a.glb')!);
  // three.js renames objects with duplicate names: a mesh is the one that is where the object is at all times.
  const skins = scene.objects.filter(({ motion }) => {
    const samples = pointSamples(motion);
    return samples !== undefined && isBlended(samples.points);
  });
  expect(skins).toHaveLength(6);
  const worst = skins.map(() => meshes.map(() => 0));
  for (const t of [0, 0.4, 1, 1.7, 2.9]) {
    // glTF has no times before 0.
    showAt(t);
    const places = meshes.map((mesh) =>
      Array.from({ length: mesh.geometry.getAttribute('position').count }, (_, v) => {
        const { x, y, z } = mesh.localToWorld(mesh.getVertexPosition(v, new Vector3()));
        return [x, y, z] as const;
      }),
    );
    skins.forEach((object, i) => {
      const count = object.mesh.positions.length / 3;
      const own = Array.from({ length: count }, (_, v) => vertexPosition(object, v, t + scene.startTime, 1e9));
      places.forEach((other, m) => {
        const off = other.length === count ? Math.max(...own.map((p, v) => distance(p, other[v]))) : Infinity;
        worst[i][m] = Math.max(worst[i][m], off);
      });
    });
  }
  skins.forEach(({ path }, i) => {
    expect(Math.min(...worst[i]), path).toBeLessThan(1e-3);
  });
});
