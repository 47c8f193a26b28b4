import { Document, type Node as GltfNode, type Primitive, WebIO } from '@gltf-transform/core';
import { KHRMaterialsEmissiveStrength, KHRMaterialsUnlit, KHRTextureTransform } from '@gltf-transform/extensions';
import { describe, expect, it } from 'vitest';
import { fromAxisAngle } from '../../math/quat.ts';
import { distance, type Vec3 } from '../../math/vec3.ts';
import { vertexPosition } from '../../scene/motion.ts';
import type { Scene, SceneObject } from '../../scene/types.ts';
import { encodePng } from '../png.ts';
import type { ReadOptions } from '../registry.ts';
import { memorySource } from '../source.ts';
import { readGltf } from './index.ts';

const C = 1e9;

/** A document under construction: one buffer, short ways to fill it. */
class Kit {
  readonly doc = new Document();
  readonly scene = this.doc.createScene('Stage');
  readonly #buffer = this.doc.createBuffer();
  readonly animation = this.doc.createAnimation('Move');

  values(type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4' | 'MAT4', numbers: readonly number[]) {
    return this.doc.createAccessor().setType(type).setArray(Float32Array.from(numbers)).setBuffer(this.#buffer);
  }
  ints(type: 'SCALAR' | 'VEC4', numbers: readonly number[]) {
    return this.doc.createAccessor().setType(type).setArray(Uint16Array.from(numbers)).setBuffer(this.#buffer);
  }
  triangle(points: readonly number[] = [0, 0, 0, 1, 0, 0, 0, 1, 0]): Primitive {
    return this.doc.createPrimitive().setAttribute('POSITION', this.values('VEC3', points));
  }
  meshNode(name: string, ...primitives: Primitive[]): GltfNode {
    const mesh = this.doc.createMesh(name);
    for (const p of primitives) mesh.addPrimitive(p);
    return this.doc.createNode(name).setMesh(mesh);
  }
  animate(
    node: GltfNode,
    path: 'translation' | 'rotation' | 'scale' | 'weights',
    times: readonly number[],
    output: readonly number[],
    kind: 'LINEAR' | 'STEP' | 'CUBICSPLINE' = 'LINEAR',
  ): void {
    const type = path === 'weights' ? 'SCALAR' : path === 'rotation' ? 'VEC4' : 'VEC3';
    const sampler = this.doc
      .createAnimationSampler()
      .setInput(this.values('SCALAR', times))
      .setOutput(this.values(type, output))
      .setInterpolation(kind);
    const channel = this.doc.createAnimationChannel().setTargetNode(node).setTargetPath(path).setSampler(sampler);
    this.animation.addSampler(sampler).addChannel(channel);
  }
  async read(options?: ReadOptions): Promise<Scene> {
    const io = new WebIO().registerExtensions([KHRMaterialsEmissiveStrength, KHRMaterialsUnlit, KHRTextureTransform]);
    return readGltf(memorySource({ 'a.glb': await io.writeBinary(this.doc) }), 'a.glb', options);
  }
}

const zAxis: Vec3 = [0, 0, 1];
const turnKeys = (angles: readonly number[]): number[] => angles.flatMap((angle) => [...fromAxisAngle(zAxis, angle)]);
const find = (scene: Scene, path: string): SceneObject => {
  const object = scene.objects.find((o) => o.path === path);
  if (!object) throw new Error(`no ${path} among ${scene.objects.map((o) => o.path).join(', ')}`);
  return object;
};

/** Greatest distance of all vertices from a formula, over times off the keys. */
function worstError(object: SceneObject, truth: (vertex: number, t: number) => Vec3, from: number, to: number): number {
  let worst = 0;
  for (let k = 0; k <= 97; k++) {
    const t = from + ((to - from) * k) / 97;
    for (let v = 0; v < object.mesh.positions.length / 3; v++) {
      worst = Math.max(worst, distance(vertexPosition(object, v, t, C), truth(v, t)));
    }
  }
  return worst;
}

describe('glTF motion', () => {
  it('a turning node becomes rigid samples within the chord tolerance', async () => {
    const kit = new Kit();
    const node = kit.meshNode('Blade', kit.triangle([1, 0, 0, 3, 0, 0, 3, 1, 0])).setTranslation([5, 0, 0]);
    kit.scene.addChild(node);
    kit.animate(node, 'rotation', [1, 2, 3, 4], turnKeys([0, 2, 4, 6]));
    const scene = await kit.read();
    const blade = find(scene, '/Blade');
    expect(blade.motion.kind).toBe('sampled');
    const rest: Vec3[] = [
      [1, 0, 0],
      [3, 0, 0],
      [3, 1, 0],
    ];
    const truth = (v: number, t: number): Vec3 => {
      const angle = 2 * (Math.min(4, Math.max(1, t)) - 1);
      const [x, y] = rest[v];
      return [5 + x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), 0];
    };
    // Half the diagonal of the triangle is √5/2.
    expect(worstError(blade, truth, 0, 5)).toBeLessThan(1.05e-4 * 1.12);
    expect([scene.startTime, scene.endTime]).toEqual([1, 4]);
    const coarse = find(await kit.read({ chordTolerance: 0.1 }), '/Blade');
    expect(coarse.motion.kind === 'sampled' && coarse.motion.times.length).toBeLessThan(20);
  });

  it('a moon round a planet round nothing: rotations along a hierarchy', async () => {
    const kit = new Kit();
    const moon = kit.meshNode('Moon', kit.triangle()).setTranslation([2, 0, 0]);
    const planet = kit.doc.createNode('Planet').setTranslation([10, 0, 0]).addChild(moon);
    const sun = kit.doc.createNode('Sun').addChild(planet);
    kit.scene.addChild(sun);
    kit.animate(sun, 'rotation', [0, 1, 2], turnKeys([0, 1, 2]));
    kit.animate(planet, 'rotation', [0, 0.5, 2], turnKeys([0, 2, -1]));
    const object = find(await kit.read(), '/Sun/Planet/Moon');
    expect(object.motion.kind).toBe('sampled');
    const rest = [
      [0, 0],
      [1, 0],
      [0, 1],
    ];
    const truth = (v: number, t: number): Vec3 => {
      const b = t + (t < 0.5 ? 4 * t : 2 - (3 * (t - 0.5)) / 1.5);
      const [x, y] = [rest[v][0] + 2, rest[v][1]];
      return [
        10 * Math.cos(t) + x * Math.cos(b) - y * Math.sin(b),
        10 * Math.sin(t) + x * Math.sin(b) + y * Math.cos(b),
        0,
      ];
    };
    expect(worstError(object, truth, 0, 2)).toBeLessThan(1.05e-4);
  });

  it('a cubic spline follows its Hermite polynomial', async () => {
    const kit = new Kit();
    const node = kit.meshNode('Ball', kit.triangle());
    kit.scene.addChild(node);
    // x = t³ − t on 0 … 2, whose Hermite form between two keys is itself: slopes 3t² − 1.
    const key = (t: number): number[] => [3 * t * t - 1, 0, 0, t ** 3 - t, 0, 0, 3 * t * t - 1, 0, 0];
    kit.animate(node, 'translation', [0, 2], [...key(0), ...key(2)], 'CUBICSPLINE');
    const ball = find(await kit.read(), '/Ball');
    const rest: Vec3[] = [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ];
    const truth = (v: number, t: number): Vec3 => [rest[v][0] + t ** 3 - t, rest[v][1], 0];
    expect(worstError(ball, truth, 0, 2)).toBeLessThan(1e-4);
  });

  it('growing becomes sampled points', async () => {
    const kit = new Kit();
    const node = kit.meshNode(
      'Balloon',
      kit.triangle().setAttribute('NORMAL', kit.values('VEC3', [0, 0, 1, 0, 0, 1, 0, 0, 1])),
    );
    kit.scene.addChild(node);
    kit.animate(node, 'scale', [0, 4], [1, 1, 1, 3, 1, 1]);
    const balloon = find(await kit.read(), '/Balloon');
    expect(balloon.motion.kind).toBe('sampled-points');
    const rest: Vec3[] = [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ];
    expect(worstError(balloon, (v, t) => [rest[v][0] * (1 + t / 2), rest[v][1], 0], 0, 4)).toBeLessThan(1e-6);
  });

  it('morph targets move by their weights', async () => {
    const kit = new Kit();
    const up = kit.doc
      .createPrimitiveTarget()
      .setAttribute('POSITION', kit.values('VEC3', [0, 0, 1, 0, 0, 1, 0, 0, 5]));
    const side = kit.doc
      .createPrimitiveTarget()
      .setAttribute('POSITION', kit.values('VEC3', [2, 0, 0, 0, 0, 0, 0, 0, 0]));
    const node = kit.meshNode('Face', kit.triangle().addTarget(up).addTarget(side));
    node.getMesh()?.setWeights([0, 0]);
    kit.scene.addChild(node);
    kit.animate(node, 'weights', [0, 1, 3], [0, 0, 1, 0.5, 0, 1]);
    const face = find(await kit.read(), '/Face');
    const rest: Vec3[] = [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ];
    const truth = (v: number, t: number): Vec3 => {
      const [a, b] = t < 1 ? [t, t / 2] : [1 - (t - 1) / 2, 0.5 + (t - 1) / 4];
      return [rest[v][0] + (v === 0 ? 2 * b : 0), rest[v][1], a * (v === 2 ? 5 : 1)];
    };
    expect(worstError(face, truth, 0, 3)).toBeLessThan(1e-6);
  });

  it('a two-joint arm bends as worked out by hand', async () => {
    const kit = new Kit();
    // An arm along x: the root joint at 0, the elbow at x = 2. Vertices: shoulder, one half on each joint, hand.
    const arm = kit
      .triangle([1, 0, 0, 2, 1, 0, 4, 0, 0])
      .setAttribute('JOINTS_0', kit.ints('VEC4', [0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 9]))
      .setAttribute('WEIGHTS_0', kit.values('VEC4', [1, 0, 0, 0, 0.5, 0.5, 0, 0, 1, 0, 0, 0]));
    const elbow = kit.doc.createNode('Elbow').setTranslation([2, 0, 0]);
    const root = kit.doc.createNode('Root').addChild(elbow).setTranslation([0, 7, 0]);
    const binds = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -2, 0, 0, 1];
    const skin = kit.doc.createSkin().addJoint(root).addJoint(elbow).setInverseBindMatrices(kit.values('MAT4', binds));
    const node = kit.meshNode('Arm', arm).setSkin(skin).setTranslation([100, 100, 100]);
    kit.scene.addChild(root).addChild(node);
    kit.animate(elbow, 'rotation', [0, 2], turnKeys([0, 2]));
    const object = find(await kit.read(), '/Arm');
    expect(object.motion.kind).toBe('sampled-points');
    const truth = (v: number, t: number): Vec3 => {
      // About the elbow: (0, 1) → (−sin t, cos t), (2, 0) → 2 (cos t, sin t).
      if (v === 0) return [1, 7, 0];
      if (v === 1) return [2 - Math.sin(t) / 2, 7 + (1 + Math.cos(t)) / 2, 0];
      return [2 + 2 * Math.cos(t), 7 + 2 * Math.sin(t), 0];
    };
    expect(worstError(object, truth, 0, 2)).toBeLessThan(1.05e-3 * 1.6);
    const normals = object.motion.kind === 'sampled-points' ? object.motion.normals : undefined;
    expect(normals?.every((n) => Math.abs(n[2] + 1) < 1e-6)).toBe(true);
  });

  it('a step is a short ramp, and said', async () => {
    const kit = new Kit();
    const node = kit.meshNode('Lamp', kit.triangle());
    kit.scene.addChild(node);
    kit.animate(node, 'translation', [0, 1, 2], [0, 0, 0, 6, 0, 0, 6, 0, 0], 'STEP');
    const scene = await kit.read();
    const lamp = find(scene, '/Lamp');
    expect(vertexPosition(lamp, 0, 0.9985, C)).toEqual([0, 0, 0]);
    expect(vertexPosition(lamp, 0, 1, C)).toEqual([6, 0, 0]);
    expect(vertexPosition(lamp, 0, 1.5, C)).toEqual([6, 0, 0]);
    expect(scene.diagnostics).toMatchObject([{ code: 'gltf.jump', place: 'a.glb: /Lamp' }]);
  });

  it('a mirrored child of a turning parent stays rigid and right side out', async () => {
    const kit = new Kit();
    const child = kit.meshNode('Glove', kit.triangle()).setScale([-2, 2, 2]);
    const hand = kit.doc.createNode('Hand').addChild(child);
    kit.scene.addChild(hand);
    kit.animate(hand, 'rotation', [0, 1], turnKeys([0, 1]));
    const glove = find(await kit.read(), '/Hand/Glove');
    expect(glove.motion.kind).toBe('sampled');
    expect([...glove.mesh.positions]).toEqual([0, 0, 0, -2, 0, 0, 0, 2, 0]);
    expect([...glove.mesh.indices]).toEqual([0, 2, 1]);
    expect(glove.mesh.normals[2]).toBe(1);
  });

  it('shows the animation that is asked for, and names them all', async () => {
    const kit = new Kit();
    const node = kit.meshNode('Cube', kit.triangle());
    kit.scene.addChild(node);
    const other = kit.doc.createAnimation('Rest');
    kit.animate(node, 'translation', [0, 1], [0, 0, 0, 1, 0, 0]);
    const first = await kit.read();
    expect(find(first, '/Cube').motion.kind).toBe('sampled');
    expect(first.diagnostics[0].message).toBe('2 animations (Move, Rest); Move is shown');
    expect(find(await kit.read({ animation: 'Rest' }), '/Cube').motion.kind).toBe('static');
    expect(other.listChannels()).toEqual([]);
    await expect(kit.read({ animation: 'Jump' })).rejects.toThrow('no animation Jump; there are Move, Rest');
  });
});

describe('glTF meshes', () => {
  it('strips and fans become triangles, lines are named', async () => {
    const kit = new Kit();
    const square = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];
    const normals = kit.values('VEC3', [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
    const strip = kit.triangle(square).setMode(5).setAttribute('NORMAL', normals);
    const fan = kit.triangle([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]).setMode(6).setAttribute('NORMAL', normals);
    kit.scene.addChild(kit.meshNode('Strip', strip)).addChild(kit.meshNode('Fan', fan));
    kit.scene.addChild(kit.meshNode('Wire', kit.triangle().setMode(1)));
    const scene = await kit.read();
    expect([...find(scene, '/Strip').mesh.indices]).toEqual([0, 1, 2, 1, 3, 2]);
    expect([...find(scene, '/Fan').mesh.indices]).toEqual([1, 2, 0, 2, 3, 0]);
    expect(scene.objects.length).toBe(2);
    expect(scene.diagnostics).toMatchObject([{ code: 'gltf.primitive', place: 'a.glb: mesh Wire' }]);
  });

  it('without normals triangles are flat, and share no vertex', async () => {
    const kit = new Kit();
    const fold = kit.triangle([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]).setIndices(kit.ints('SCALAR', [0, 1, 2, 0, 3, 1]));
    kit.scene.addChild(kit.meshNode('Fold', fold));
    const { mesh } = find(await kit.read(), '/Fold');
    expect([...mesh.indices]).toEqual([0, 1, 2, 3, 4, 5]);
    expect([...mesh.normals]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0]);
    expect([...mesh.uvs]).toEqual(new Array(12).fill(0));
  });

  it('joins primitives, keeps their materials, reads colours, turns v up and applies texture transforms', async () => {
    const kit = new Kit();
    const png = encodePng(1, 2, Uint8Array.from([255, 0, 0, 9, 0, 0, 255, 9]));
    const image = kit.doc.createTexture('Paint').setImage(png).setMimeType('image/png');
    const red = kit.doc.createMaterial('Red').setBaseColorTexture(image).setBaseColorFactor([1, 0.5, 0.25, 0.5]);
    const transform = kit.doc.createExtension(KHRTextureTransform).createTransform();
    transform
      .setOffset([0.5, 0])
      .setScale([1, 2])
      .setRotation(Math.PI / 2);
    red.getBaseColorTextureInfo()?.setExtension('KHR_texture_transform', transform).setMagFilter(9728).setWrapS(33071);
    const strong = kit.doc
      .createExtension(KHRMaterialsEmissiveStrength)
      .createEmissiveStrength()
      .setEmissiveStrength(4);
    const glow = kit.doc.createMaterial('Glow').setEmissiveFactor([1, 0, 0.5]).setAlphaMode('MASK').setAlphaCutoff(0.3);
    glow.setExtension('KHR_materials_emissive_strength', strong).setDoubleSided(true);
    const uvs = kit.values('VEC2', [0, 0, 1, 0, 0, 0.5]);
    const bytes = kit.doc
      .createAccessor()
      .setType('VEC4')
      .setArray(Uint8Array.from([255, 0, 0, 9, 0, 255, 0, 9, 0, 0, 255, 9]));
    const a = kit.triangle().setMaterial(red).setAttribute('TEXCOORD_0', uvs);
    const b = kit.triangle().setMaterial(glow).setAttribute('COLOR_0', bytes.setNormalized(true));
    kit.scene.addChild(kit.meshNode('Both', a, b));
    const scene = await kit.read();
    const { mesh } = find(scene, '/Both');
    expect(mesh.groups).toEqual([
      { start: 0, count: 3, material: 0 },
      { start: 3, count: 3, material: 1 },
    ]);
    expect([...mesh.colors!]).toEqual([...new Array(9).fill(1), 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    // A quarter turn: (u, v) → (v, −u) after the scale, then the offset, then v up.
    const expected = [0.5, 1, 0.5, 2, 1.5, 1];
    expected.forEach((x, i) => {
      expect(mesh.uvs[i]).toBeCloseTo(x, 6);
    });
    const [first, second] = scene.materials;
    expect(first).toMatchObject({ name: 'Red', baseColor: [1, 0.5, 0.25], opacity: 1, opacityThreshold: 0 });
    expect(first.baseColorTexture).toMatchObject({
      width: 1,
      height: 2,
      filter: 'nearest',
      wrapS: 'clamp',
      wrapT: 'repeat',
    });
    expect([...first.baseColorTexture!.data]).toEqual([255, 0, 0, 255, 0, 0, 255, 255]);
    expect(second).toMatchObject({ emissive: [4, 0, 2], opacityThreshold: 0.3 });
    expect(mesh.doubleSided).toBe(true);
    expect(scene.diagnostics.map((d) => d.code)).toEqual(['gltf.mixed-sides']);
  });

  it('an unlit material sends out its colour', async () => {
    const kit = new Kit();
    const unlit = kit.doc.createExtension(KHRMaterialsUnlit).createUnlit();
    const sign = kit.doc
      .createMaterial('Sign')
      .setBaseColorFactor([0.2, 0.4, 0.6, 1])
      .setExtension('KHR_materials_unlit', unlit);
    kit.scene.addChild(kit.meshNode('Sign', kit.triangle().setMaterial(sign)));
    const [material] = (await kit.read()).materials;
    expect(material).toMatchObject({ baseColor: [0, 0, 0], emissive: [0.2, 0.4, 0.6], metallic: 0 });
  });

  it('gives every object a path of its own that USD takes', async () => {
    const kit = new Kit();
    const parent = kit.meshNode('Körper 1.2', kit.triangle());
    parent.addChild(kit.meshNode('Mesh', kit.triangle())).addChild(kit.meshNode('Mesh', kit.triangle()));
    kit.scene.addChild(parent).addChild(kit.meshNode('3D', kit.triangle())).addChild(kit.meshNode('', kit.triangle()));
    const paths = (await kit.read()).objects.map((o) => o.path);
    expect(paths).toEqual(['/Körper_1_2/Mesh_2', '/Körper_1_2/Mesh', '/Körper_1_2/Mesh_1', '/_3D', '/Node4']);
  });

  it('a sheared matrix is kept', async () => {
    const json = {
      asset: { version: '2.0' },
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0, matrix: [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1] }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
      bufferViews: [{ buffer: 0, byteLength: 36 }],
      buffers: [{ byteLength: 36, uri: 'my%20points.bin' }],
    };
    const points = new Uint8Array(Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer);
    const files = memorySource({
      'x/a.gltf': new TextEncoder().encode(JSON.stringify(json)),
      'x/my points.bin': points,
    });
    const [object] = (await readGltf(files, 'x/a.gltf')).objects;
    const places = [0, 1, 2].map((v) => vertexPosition(object, v, 0, C));
    const expected: Vec3[] = [
      [3, 0, 0],
      [4, 0, 0],
      [3.5, 1, 0],
    ];
    for (const [v, place] of places.entries()) expect(distance(place, expected[v])).toBeLessThan(1e-6);
  });
});

describe('glTF cameras', () => {
  it('looks along its node, moving or not', async () => {
    const kit = new Kit();
    const camera = kit.doc.createCamera('Eye').setType('perspective').setYFov(0.8);
    const node = kit.doc.createNode('Eye').setCamera(camera).setTranslation([0, 0, 5]);
    kit.scene.addChild(node);
    kit.animate(node, 'translation', [0, 2], [0, 0, 5, 4, 0, 5]);
    const [eye] = (await kit.read()).cameras;
    expect(eye).toMatchObject({ path: '/Eye', fovY: 0.8 });
    expect(eye.motion).toMatchObject({ kind: 'sampled' });
    expect(eye.motion.kind === 'sampled' && [...eye.motion.poses]).toEqual([0, 0, 5, 0, 0, 0, 1, 4, 0, 5, 0, 0, 0, 1]);
  });
});
