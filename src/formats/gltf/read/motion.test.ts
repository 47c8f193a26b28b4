import { describe, expect, it } from 'vitest';
import { find, GltfBuilder } from '../../../../tests/support/gltfBuilder.ts';
import { fromAxisAngle } from '../../../math/quat.ts';
import { distance, type Vec3 } from '../../../math/vec3.ts';
import { inEnglish } from '../../../messages/message.ts';
import { pointSamples, vertexPosition } from '../../../scene/motion/motion.ts';
import { isBlended, normalsAt } from '../../../scene/streaming/samplePoints.ts';
import type { SceneObject } from '../../../scene/types.ts';
import { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { loadGltf } from '../load/loadGltf.ts';
import { Baker } from './bake.ts';
import { makeDeformer } from './deform.ts';
import { GltfMaterialLibrary } from './materials.ts';
import { NodeTree } from './nodes.ts';
import { readGeometry } from './primitives.ts';

/** Far above every speed here [m/s]. */
const C = 1e9;

const zAxis: Vec3 = [0, 0, 1];
const turnKeys = (angles: readonly number[]): number[] => angles.flatMap((angle) => [...fromAxisAngle(zAxis, angle)]);
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
  it('a rotating node becomes rigid samples within the chord tolerance', async () => {
    const kit = new GltfBuilder();
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

  it('rotations along a hierarchy: a moon orbiting a planet', async () => {
    const kit = new GltfBuilder();
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
    const kit = new GltfBuilder();
    const node = kit.meshNode('Ball', kit.triangle());
    kit.scene.addChild(node);
    // x = t³ − t on 0 … 2 is its own Hermite form between two keys: slopes 3t² − 1.
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

  it('animated scale becomes sampled points', async () => {
    const kit = new GltfBuilder();
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
    const kit = new GltfBuilder();
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

  it('constant morph weights leave a rotating mesh rigid', async () => {
    const kit = new GltfBuilder();
    const up = kit.doc
      .createPrimitiveTarget()
      .setAttribute('POSITION', kit.values('VEC3', [0, 0, 4, 0, 0, 4, 0, 0, 4]));
    const node = kit.meshNode('Head', kit.triangle().addTarget(up)).setWeights([0.5]);
    kit.scene.addChild(node);
    kit.animate(node, 'rotation', [0, 1], turnKeys([0, 1]));
    const head = find(await kit.read(), '/Head');
    expect(head.motion.kind).toBe('sampled');
    expect([...head.mesh.positions]).toEqual([0, 0, 2, 1, 0, 2, 0, 1, 2]);
  });

  it('a two-joint arm bends by the closed form', async () => {
    const kit = new GltfBuilder();
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
    const samples = pointSamples(object.motion)!;
    for (const k of samples.times.keys()) expect(normalsAt(samples, k)![2]).toBeCloseTo(-1, 6);
    expect(isBlended(samples.points)).toBe(true);
  });

  it('has fewer samples if memory is limited, which is reported', async () => {
    const kit = new GltfBuilder();
    const node = kit.meshNode('Jelly', kit.triangle());
    kit.scene.addChild(node);
    kit.animate(node, 'rotation', [0, 1, 2, 3], turnKeys([0, 2, 4, 6]));
    kit.animate(node, 'scale', [0, 3], [1, 1, 1, 2, 2, 2]);
    const bake = async (budget: number): Promise<[number[], string[]]> => {
      const notes = new DiagnosticLog('a.glb');
      const file = await loadGltf(await kit.files(), 'a.glb', notes);
      const context = { entry: 'a.glb', options: {}, variants: undefined, spectra: new Map(), notes, ...file };
      const root = context.document.getRoot();
      const tree = new NodeTree(context, root.listAnimations()[0]);
      const [jelly] = root.listNodes();
      const geometry = readGeometry(context, root.listMeshes()[0], new GltfMaterialLibrary(context))!;
      const baker = new Baker(context, 1, budget);
      const frame = tree.frame(jelly);
      const { motion } = baker.bakeAffine(frame, geometry, makeDeformer(context, tree, jelly, frame, geometry));
      const times = motion.kind === 'sampled-points' ? [...motion.times] : [];
      return [times, notes.list().map((d) => d.code)];
    };
    // One joint and the world's origin take 192 bytes per node.
    const [all, none] = await bake(1e6);
    expect([all.length > 40, none]).toEqual([true, []]);
    const [some, coarse] = await bake(192 * 20);
    expect([some.length <= 20, some.includes(1), coarse]).toEqual([true, true, ['gltf.coarse']]);
    expect(await bake(192 * 3)).toEqual([[0, 2, 3], ['gltf.coarse']]);
  });

  it('a step becomes a short ramp, which is reported', async () => {
    const kit = new GltfBuilder();
    const node = kit.meshNode('Lamp', kit.triangle());
    kit.scene.addChild(node);
    kit.animate(node, 'translation', [0, 1, 2], [0, 0, 0, 6, 0, 0, 6, 0, 0], 'STEP');
    const scene = await kit.read();
    const lamp = find(scene, '/Lamp');
    expect(vertexPosition(lamp, 0, 0.9985, C)).toEqual([0, 0, 0]);
    expect(vertexPosition(lamp, 0, 1, C)).toEqual([6, 0, 0]);
    expect(vertexPosition(lamp, 0, 1.5, C)).toEqual([6, 0, 0]);
    expect(scene.diagnostics.map((d) => [d.code, inEnglish(d.place)])).toEqual([['gltf.jump', 'a.glb: /Lamp']]);
  });

  it('a reflected child of a rotating parent stays rigid and faces outwards', async () => {
    const kit = new GltfBuilder();
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

  it('uses the requested animation, and lists all', async () => {
    const kit = new GltfBuilder();
    const node = kit.meshNode('Cube', kit.triangle());
    kit.scene.addChild(node);
    const other = kit.doc.createAnimation('Rest');
    kit.animate(node, 'translation', [0, 1], [0, 0, 0, 1, 0, 0]);
    const first = await kit.read();
    expect(find(first, '/Cube').motion.kind).toBe('sampled');
    expect(inEnglish(first.diagnostics[0].message)).toBe('2 animations (Move, Rest); Move is shown');
    expect(find(await kit.read({ animation: 'Rest' }), '/Cube').motion.kind).toBe('static');
    expect(other.listChannels()).toEqual([]);
    await expect(kit.read({ animation: 'Jump' })).rejects.toThrow('no animation Jump; there are Move, Rest');
  });
});

it('objects that move too fast between keys share a limit of samples, and are reported', async () => {
  const kit = new GltfBuilder();
  const wild = Array.from({ length: 20 }, (_, i) => kit.meshNode(`Wild${i}`, kit.triangle()));
  // A spline whose tangents move it back and forth by 10⁶ m.
  const keys = Array.from({ length: 60 }, (_, i) => i);
  for (const node of wild) {
    kit.scene.addChild(node);
    const values = keys.flatMap(() => [1e6, 0, 0, 0, 0, 0, -1e6, 1e6, 0]);
    kit.animate(node, 'translation', keys, values, 'CUBICSPLINE');
  }
  const scene = await kit.read();
  const counts = scene.objects.map(({ motion }) => ('times' in motion ? motion.times.length : 0));
  // Six evaluations of two curves per added sample, out of the 2¹⁷ allowed.
  expect(counts.reduce((sum, n) => sum + n)).toBeLessThan(20 * 60 + 2 ** 17 / 12);
  const said = scene.diagnostics.filter((d) => d.code === 'gltf.resampling');
  expect(said).toHaveLength(20);
  expect(inEnglish(said[0].place)).toBe('a.glb: /Wild0');
  expect(inEnglish(said[0].message)).toMatch(
    /between its 60 keys .*about [\d.e+]+ samples would be needed, \d+ are used, .* m;/,
  );
});
