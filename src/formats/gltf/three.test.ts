import { Document, type Node as GltfNode, WebIO } from '@gltf-transform/core';
import { AnimationMixer, type Mesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { describe, expect, it } from 'vitest';
import { fromAxisAngle } from '../../math/quat.ts';
import { random } from '../../math/random.ts';
import { distance } from '../../math/vec3.ts';
import { vertexPosition } from '../../scene/motion/motion.ts';
import { memorySource } from '../files/fileSource.ts';
import { readGltf } from './index.ts';

/** Random animated documents in three.js and here: every vertex has the same position at many times. */

type Path = 'translation' | 'rotation' | 'scale' | 'weights';
type Kind = 'LINEAR' | 'CUBICSPLINE';

function randomDocument(next: () => number): Document {
  const doc = new Document();
  const buffer = doc.createBuffer();
  const animation = doc.createAnimation('Move');
  const between = (a: number, b: number): number => a + (b - a) * next();
  const many = (n: number, f: () => number): number[] => Array.from({ length: n }, f);
  const axis = (): [number, number, number] => [between(-1, 1), between(-1, 1), between(0.1, 1)];
  const values = (type: 'SCALAR' | 'VEC3' | 'VEC4' | 'MAT4', array: readonly number[]) =>
    doc.createAccessor().setType(type).setArray(Float32Array.from(array)).setBuffer(buffer);
  const sample: Record<Path, () => number[]> = {
    translation: () => many(3, () => between(-3, 3)),
    rotation: () => [...fromAxisAngle(axis(), between(-2, 2))],
    scale: () => many(3, () => between(0.5, 2)),
    weights: () => many(2, () => between(0, 1)),
  };
  const animate = (node: GltfNode, path: Path, kind: Kind): void => {
    const times = [between(0, 0.5), between(0.6, 1.2), between(1.4, 2)];
    const zeros = sample[path]().map(() => 0);
    // Tangents are small, so that a spline of quaternions stays far from 0.
    const tangent = (): number[] => zeros.map(() => between(-0.3, 0.3));
    const keys = times.flatMap(() =>
      kind === 'LINEAR' ? sample[path]() : [...tangent(), ...sample[path](), ...tangent()],
    );
    const type = path === 'weights' ? 'SCALAR' : path === 'rotation' ? 'VEC4' : 'VEC3';
    const sampler = doc.createAnimationSampler().setInput(values('SCALAR', times)).setOutput(values(type, keys));
    const channel = doc.createAnimationChannel().setTargetNode(node).setTargetPath(path);
    animation.addSampler(sampler.setInterpolation(kind)).addChannel(channel.setSampler(sampler));
  };
  const vertices = 12;
  const primitive = () =>
    doc
      .createPrimitive()
      .setAttribute(
        'POSITION',
        values(
          'VEC3',
          many(vertices * 3, () => between(-1, 1)),
        ),
      )
      .setAttribute(
        'NORMAL',
        values(
          'VEC3',
          many(vertices, () => 0).flatMap(() => [0, 0, 1]),
        ),
      );
  const node = (name: string, parent?: GltfNode): GltfNode => {
    const made = doc.createNode(name).setTranslation([between(-2, 2), between(-2, 2), 0]);
    made.setRotation([...fromAxisAngle(axis(), between(-1, 1))]).setScale([between(0.5, 2), 1, between(0.5, 2)]);
    parent?.addChild(made);
    return made;
  };
  const scene = doc.createScene('Stage');
  const top = node('Top');
  const turning = node('Turning', top);
  const plain = node('Plain', turning).setMesh(doc.createMesh().addPrimitive(primitive()));
  scene.addChild(top);
  animate(top, 'translation', 'CUBICSPLINE');
  animate(turning, 'rotation', 'LINEAR');
  animate(plain, 'rotation', 'CUBICSPLINE');
  animate(plain, 'scale', 'LINEAR');
  const morphed = primitive();
  for (let k = 0; k < 2; k++) {
    const target = doc.createPrimitiveTarget().setAttribute('POSITION', values('VEC3', many(vertices * 3, next)));
    morphed.addTarget(
      target.setAttribute(
        'NORMAL',
        values(
          'VEC3',
          many(vertices * 3, () => 0),
        ),
      ),
    );
  }
  const bending = node('Bending', turning).setMesh(doc.createMesh().setWeights([0.2, 0.1]).addPrimitive(morphed));
  animate(bending, 'weights', 'LINEAR');
  animate(bending, 'translation', 'LINEAR');
  const joints = [node('J0', top)];
  for (let j = 1; j < 3; j++) joints.push(node(`J${j}`, joints[j - 1]));
  for (const joint of joints) animate(joint, 'rotation', 'LINEAR');
  const jointOf = doc.createAccessor().setType('VEC4').setBuffer(buffer);
  const weights = Array.from({ length: vertices }, () => many(3, () => between(0.1, 1))).map((w) => {
    const sum = w[0] + w[1] + w[2];
    return [...w.map((x) => x / sum), 0];
  });
  const skinned = primitive()
    .setAttribute('JOINTS_0', jointOf.setArray(Uint8Array.from(many(vertices, () => 0).flatMap(() => [0, 1, 2, 0]))))
    .setAttribute('WEIGHTS_0', values('VEC4', weights.flat()));
  const bind = (): number[] => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...many(3, () => between(-1, 1)), 1];
  const skin = doc.createSkin().setInverseBindMatrices(values('MAT4', [bind(), bind(), bind()].flat()));
  for (const joint of joints) skin.addJoint(joint);
  scene.addChild(node('Skinned').setMesh(doc.createMesh().addPrimitive(skinned)).setSkin(skin));
  return doc;
}

describe('glTF agrees with three.js', () => {
  it.each([1, 2, 3, 4])('random document %i', async (seed) => {
    const glb = await new WebIO().writeBinary(randomDocument(random(seed)));
    const scene = await readGltf(memorySource({ 'a.glb': glb }), 'a.glb', { chordTolerance: 5e-5 });
    const gltf = await new GLTFLoader().parseAsync(glb.slice().buffer, '');
    const mixer = new AnimationMixer(gltf.scene);
    mixer.clipAction(gltf.animations[0]).play();
    const names = { Plain: '/Top/Turning/Plain', Bending: '/Top/Turning/Bending', Skinned: '/Skinned' };
    const worst: Record<string, number> = { Plain: 0, Bending: 0, Skinned: 0 };
    for (let t = 0; t < scene.endTime; t += 0.087) {
      mixer.setTime(t);
      gltf.scene.updateMatrixWorld(true);
      for (const [name, path] of Object.entries(names)) {
        const mesh = gltf.scene.getObjectByName(name) as Mesh;
        const object = scene.objects.find((o) => o.path === path)!;
        for (let v = 0; v < object.mesh.positions.length / 3; v++) {
          const p = mesh.localToWorld(mesh.getVertexPosition(v, new Vector3()));
          const off = distance([p.x, p.y, p.z], vertexPosition(object, v, t, 1e9));
          worst[name] = Math.max(worst[name], off);
        }
      }
    }
    // 5e-5 of half the diagonal, which is less than 30 m here; three.js keeps its matrices in f64, its keys in f32.
    for (const name of Object.keys(names)) expect(worst[name]).toBeLessThan(1.5e-3);
  });
});
