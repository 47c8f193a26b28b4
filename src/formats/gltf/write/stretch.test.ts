import { Matrix3, type Mesh as ThreeMesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { expect, it } from 'vitest';
import { fromAxisAngle, rotate } from '../../../math/quat.ts';
import { distance, dot, type Vec3 } from '../../../math/vec3.ts';
import { makeObject, makeScene } from '../../../scene/defaults.ts';
import { sphere } from '../../../scene/mesh/primitives.ts';
import { withoutQuadric } from '../../../scene/mesh/quadric.ts';
import { objectNormal } from '../../../scene/mesh/stretch.ts';
import { vertexPosition } from '../../../scene/motion/motion.ts';
import { memorySource } from '../../files/fileSource.ts';
import { readGltf } from '../read/read.ts';
import { writeGltf } from './write.ts';

const ball = withoutQuadric(sphere(0.5, { segments: 12, rings: 8 }));
const STRETCHES = [
  undefined,
  [2, 0, 0, 0, 1, 0, 0, 0, 0.5],
  [-1, 0, 0, 0, -3, 0, 0, 0, 1],
  [1, 0.4, 0, 0, 1, 0, 0, 0, 2],
];

const scene = makeScene({
  name: 'stretched',
  upAxis: 'Z',
  objects: STRETCHES.map((stretch, i) =>
    makeObject({
      path: `/Ball${i}`,
      mesh: ball,
      motion: { kind: 'static', pose: { position: [3 * i, 1, 2], orientation: fromAxisAngle([0.6, 0, 0.8], i) } },
      ...(stretch && { stretch }),
    }),
  ),
});

const yUp = ([x, y, z]: Vec3): Vec3 => [x, z, -y];

it('three.js shows stretched bodies where they are, with their normals; those that are only scaled share a mesh', async () => {
  const { files } = await writeGltf(scene, 'a.glb');
  const glb = files.get('a.glb')!;
  const { scene: shown, parser } = await new GLTFLoader().parseAsync(glb.slice().buffer, '');
  expect((parser as { json: { meshes: unknown[] } }).json.meshes).toHaveLength(2);
  shown.updateMatrixWorld(true);
  scene.objects.forEach((object, k) => {
    const mesh = shown.getObjectByName(`Ball${k}`) as ThreeMesh;
    const { position, normal } = mesh.geometry.attributes;
    const normalMatrix = new Matrix3().getNormalMatrix(mesh.matrixWorld);
    expect(position.count).toBe(ball.positions.length / 3);
    for (let i = 0; i < position.count; i++) {
      const at = new Vector3().fromBufferAttribute(position, i).applyMatrix4(mesh.matrixWorld).toArray();
      expect(distance(at, yUp(vertexPosition(object, i, 0, 1e9)))).toBeLessThan(1e-5);
      const n = new Vector3().fromBufferAttribute(normal, i).applyMatrix3(normalMatrix).normalize().toArray();
      const { orientation } =
        object.motion.kind === 'static' ? object.motion.pose : { orientation: [0, 0, 0, 1] as const };
      expect(dot(n, yUp(rotate(orientation, objectNormal(object, i))))).toBeGreaterThan(1 - 1e-5);
    }
  });
});

it('they are read back where they are, and share their mesh', async () => {
  const { files } = await writeGltf(scene, 'a.glb');
  const back = await readGltf(memorySource({ 'a.glb': files.get('a.glb')! }), 'a.glb');
  back.objects.forEach((object, k) => {
    for (let i = 0; i < 20; i++)
      expect(
        distance(vertexPosition(object, i, 0, 1e9), yUp(vertexPosition(scene.objects[k], i, 0, 1e9))),
      ).toBeLessThan(1e-5);
  });
  expect(new Set(back.objects.slice(0, 3).map(({ mesh }) => mesh)).size).toBe(1);
});
