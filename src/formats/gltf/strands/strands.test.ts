import type { Node as GltfNode, Primitive } from '@gltf-transform/core';
import { KHRMaterialsUnlit } from '@gltf-transform/extensions';
import { describe, expect, it } from 'vitest';
import { find, GltfBuilder } from '../../../../tests/support/gltfBuilder.ts';
import { addScaled, cross, distance, dot, length, sub, type Vec3 } from '../../../math/vec3.ts';
import { inEnglish } from '../../../messages/message.ts';
import { pointAt } from '../../../scene/mesh/polygons.ts';
import { vertexPosition } from '../../../scene/motion/motion.ts';
import type { Scene, SceneObject } from '../../../scene/types.ts';
import { MAX_SPHERES } from '../../read/strands/pointSpheres.ts';
import { MAX_SURFACE_POINTS } from '../../read/strands/sweep.ts';

const [POINTS, LINES, LINE_LOOP, LINE_STRIP] = [0, 1, 2, 3] as const;
const C = 3e8;

const verticesOf = (object: SceneObject, t = 0): Vec3[] =>
  Array.from({ length: object.mesh.positions.length / 3 }, (_, i) => vertexPosition(object, i, t, C));
const toSegment = (p: Vec3, a: Vec3, b: Vec3): number => {
  const [way, from] = [sub(b, a), sub(p, a)];
  const s = Math.min(1, Math.max(0, dot(from, way) / dot(way, way)));
  return distance(p, addScaled(a, way, s));
};
/** By Gauss's theorem; positive if the triangles face outwards. */
function volumeOf(object: SceneObject): number {
  const at = verticesOf(object);
  const { indices } = object.mesh;
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3)
    sum += dot(at[indices[i]], cross(at[indices[i + 1]], at[indices[i + 2]])) / 6;
  return sum;
}
/** Area of the regular polygon in a circle. */
const polygonArea = (sides: number, radius: number): number =>
  (sides / 2) * radius ** 2 * Math.sin((2 * Math.PI) / sides);

/** A node with one primitive, read. */
async function shown(
  mode: Primitive['getMode'] extends () => infer M ? M : never,
  points: readonly number[],
  more: (kit: GltfBuilder, p: Primitive, node: GltfNode) => void = () => {},
): Promise<Scene> {
  const kit = new GltfBuilder();
  const primitive = kit.triangle(points).setMode(mode);
  const node = kit.meshNode('Thing', primitive);
  kit.scene.addChild(node);
  more(kit, primitive, node);
  return kit.read();
}
const thing = (scene: Scene): SceneObject => find(scene, '/Thing');

describe('points', () => {
  const CORNERS = [0, 0, 0, 300, 0, 0, 300, 400, 0];

  it('are spheres of a 250th of the scene’s size, with their colours, unlit', async () => {
    const scene = await shown(POINTS, CORNERS, (kit, p) => {
      p.setAttribute('COLOR_0', kit.values('VEC3', [1, 0, 0, 0, 1, 0, 0, 0, 1]));
      p.setMaterial(kit.doc.createMaterial('Paint').setBaseColorFactor([0.5, 0.25, 1, 1]));
    });
    const { mesh } = thing(scene);
    expect(scene.materials).toMatchObject([{ unlit: true, baseColor: [0, 0, 0], emissive: [0.5, 0.25, 1] }]);
    const each = mesh.positions.length / 9;
    verticesOf(thing(scene)).forEach((p, i) => {
      const k = Math.floor(i / each);
      expect(distance(p, pointAt(CORNERS, k))).toBeCloseTo(1, 4);
      expect([...mesh.colors!.subarray(3 * i, 3 * i + 3)]).toEqual([0, 1, 2].map((j) => (j === k ? 1 : 0)));
    });
    expect(scene.diagnostics.map((d) => [d.severity, d.code])).toEqual([['info', 'gltf.primitive']]);
    expect(inEnglish(scene.diagnostics[0].message)).toContain('spheres 2 m across and lines as tubes 1 m wide');
  });

  it('with normals are lit, also by the default material', async () => {
    const lit = await shown(POINTS, [0, 0, 0, 1, 0, 0], (kit, p) => {
      p.setAttribute('NORMAL', kit.values('VEC3', [0, 0, 1, 0, 0, 1]));
    });
    expect(lit.materials[0].unlit).toBeUndefined();
    const { normals } = thing(lit).mesh;
    // The spheres' own.
    verticesOf(thing(lit)).forEach((p, i) => {
      const outward = sub(p, p[0] > 0.5 ? [1, 0, 0] : [0, 0, 0]);
      expect(dot(pointAt(normals, i), outward)).toBeCloseTo(length(outward), 5);
    });
  });

  it('of one material beside triangles stay unlit, and the triangles lit', async () => {
    const scene = await shown(POINTS, [0, 0, 0], (kit, p, node) => {
      const paint = kit.doc.createMaterial('Paint');
      node.getMesh()!.addPrimitive(kit.triangle().setMaterial(paint));
      p.setMaterial(paint);
    });
    expect(thing(scene).mesh.groups.map(({ material }) => scene.materials[material].unlit)).toEqual([true, undefined]);
  });

  it('of an unlit material share it with triangles', async () => {
    const scene = await shown(POINTS, [0, 0, 0], (kit, p, node) => {
      const unlit = kit.doc.createExtension(KHRMaterialsUnlit).createUnlit();
      const paint = kit.doc.createMaterial('Paint').setExtension('KHR_materials_unlit', unlit);
      node.getMesh()!.addPrimitive(kit.triangle().setMaterial(paint));
      p.setMaterial(paint);
    });
    expect(scene.materials).toHaveLength(1);
  });

  it('are drawn evenly where they are too many in all meshes together', async () => {
    const kit = new GltfBuilder();
    const many = Array.from({ length: 3 * MAX_SPHERES }, (_, i) => i);
    kit.scene.addChild(kit.meshNode('A', kit.triangle(many).setMode(POINTS)));
    kit.scene.addChild(kit.meshNode('B', kit.triangle([0, 0, 0, 1, 1, 1]).setMode(POINTS)));
    const scene = await kit.read();
    const triangles = scene.objects.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
    expect(triangles).toBe(8 * (MAX_SPHERES / 2 + 1));
    expect(scene.diagnostics.map((d) => d.severity)).toEqual(['info', 'warning']);
  });
});

describe('lines', () => {
  it('are tubes that are round in the world, however their node stretches, turns and mirrors them', async () => {
    const scene = await shown(LINE_STRIP, [-1, 2, 0, 1, 2, 0], (_kit, _p, node) => {
      node.setScale([50, 0.5, -3]).setRotation([0.5, 0.5, 0.5, 0.5]).setTranslation([7, 0, 0]);
    });
    const object = thing(scene);
    // x → y → z → x by the rotation: from (7, -50, 1) to (7, 50, 1), of size 100.
    const at = verticesOf(object);
    for (const p of at) expect(toSegment(p, [7, -50, 1], [7, 50, 1])).toBeCloseTo(0.1, 4);
    expect(Math.max(...at.map(([, y]) => y))).toBeCloseTo(50, 4);
    expect(volumeOf(object)).toBeCloseTo(polygonArea(8, 0.1) * 100, 2);
  });

  it('that share corners are one; loops close, without lids', async () => {
    const square = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
    const loop = thing(await shown(LINE_LOOP, square));
    const pairs = thing(
      await shown(LINES, square, (kit, p) => {
        p.setIndices(kit.ints('SCALAR', [0, 1, 1, 2, 2, 3, 3, 0]));
      }),
    );
    expect(loop.mesh.positions).toHaveLength(3 * 4 * 8);
    expect(pairs.mesh.positions).toEqual(loop.mesh.positions);
    const radius = Math.SQRT2 / 1000;
    const sides = square.flatMap((_, i) => (i % 3 === 0 ? [pointAt(square, i / 3)] : []));
    for (const p of verticesOf(loop))
      expect(Math.min(...sides.map((a, i) => toSegment(p, a, sides[(i + 1) % 4])))).toBeLessThan(radius * 1.4143);
    // Mitred: of the same width everywhere.
    expect(volumeOf(loop) / (4 * polygonArea(8, radius))).toBeCloseTo(1, 4);
  });

  it('that turn back keep their width at the corner', async () => {
    const zigzag = thing(await shown(LINE_STRIP, [0, 0, 0, 10, 0, 0, 0, 1, 0, 10, 1, 0]));
    const atCorner = verticesOf(zigzag).filter((p) => distance(p, [10, 0, 0]) < 0.1);
    const radius = Math.hypot(10, 1) / 1000;
    // Two tubes with a ring and a lid each.
    expect(atCorner).toHaveLength(4 * 8);
    for (const p of atCorner) expect(distance(p, [10, 0, 0])).toBeCloseTo(radius, 5);
  });

  it('a loop that turns back twice has all its parts', async () => {
    const corners = [0, 0, 0, 10, 0, 0, 10, 0.5, 0, 0, 1, 0, -10, 0.5, 0];
    const loop = thing(await shown(LINE_LOOP, corners));
    const at = verticesOf(loop);
    for (let i = 0; i < 5; i++) {
      const [a, b] = [pointAt(corners, i), pointAt(corners, (i + 1) % 5)];
      const near = at.filter((p) => toSegment(p, a, b) < 0.03);
      expect(Math.min(...near.map((p) => distance(p, a)))).toBeLessThan(0.03);
      expect(Math.min(...near.map((p) => distance(p, b)))).toBeLessThan(0.03);
    }
    expect(volumeOf(loop)).toBeGreaterThan(0);
  });

  it('are thinner in small meshes, and a scene without size has points of 2 cm', async () => {
    const kit = new GltfBuilder();
    kit.scene.addChild(kit.meshNode('Ground', kit.triangle([0, 0, 0, 3000, 0, 0, 3000, 4000, 0])));
    kit.scene.addChild(kit.meshNode('Sign', kit.triangle([0, 0, 0, 1, 0, 0]).setMode(LINES)));
    const sign = find(await kit.read(), '/Sign');
    for (const p of verticesOf(sign)) expect(toSegment(p, [0, 0, 0], [1, 0, 0])).toBeCloseTo(0.01, 6);
    for (const p of verticesOf(thing(await shown(POINTS, [0, 0, 0])))) expect(length(p)).toBeCloseTo(0.01, 6);
  });

  it('follow morph targets and joints', async () => {
    const kit = new GltfBuilder();
    const line = kit.triangle([0, 0, 0, 1, 0, 0]).setMode(LINES);
    line.addTarget(kit.doc.createPrimitiveTarget().setAttribute('POSITION', kit.values('VEC3', [0, 0, 0, 0, 4, 0])));
    const node = kit.meshNode('Thing', line);
    kit.scene.addChild(node);
    kit.animate(node, 'weights', [0, 1], [0, 1]);
    const arm = kit.triangle([0, 0, 0, 1, 0, 0]).setMode(LINES);
    arm.setAttribute('JOINTS_0', kit.ints('VEC4', [0, 0, 0, 0, 1, 0, 0, 0]));
    arm.setAttribute('WEIGHTS_0', kit.values('VEC4', [1, 0, 0, 0, 1, 0, 0, 0]));
    const [hip, hand] = [kit.doc.createNode('Hip'), kit.doc.createNode('Hand')];
    kit.animate(hand, 'translation', [0, 1], [0, 0, 0, 0, 0, 3]);
    const skin = kit.doc.createSkin('Skin').addJoint(hip).addJoint(hand);
    kit.scene.addChild(hip).addChild(hand).addChild(kit.meshNode('Arm', arm).setSkin(skin));
    const scene = await kit.read();
    const ends = (object: SceneObject, t: number): Vec3[] => {
      const [at, start] = [verticesOf(object, t), verticesOf(object, 0)];
      const of = (isEnd: boolean): Vec3 => {
        const ring = at.filter((_, i) => start[i][0] > 0.5 === isEnd);
        return [0, 1, 2].map((k) => ring.reduce((sum, p) => sum + p[k], 0) / ring.length) as unknown as Vec3;
      };
      return [of(false), of(true)];
    };
    const near = (found: readonly Vec3[], wanted: readonly Vec3[]): void => {
      found.forEach((p, i) => {
        expect(distance(p, wanted[i])).toBeLessThan(1e-5);
      });
    };
    near(ends(thing(scene), 0.5), [
      [0, 0, 0],
      [1, 2, 0],
    ]);
    near(ends(find(scene, '/Arm'), 0.5), [
      [0, 0, 0],
      [1, 0, 1.5],
    ]);
  });

  it('have fewer corners where they are too many', async () => {
    const count = 400_000;
    const spiral = Array.from({ length: 3 * count }, (_, i) =>
      [Math.cos, Math.sin, Number][i % 3](Math.floor(i / 3) / 50),
    );
    const scene = await shown(LINE_STRIP, spiral);
    expect(thing(scene).mesh.positions.length / 3).toBeLessThan(MAX_SURFACE_POINTS + 32);
    const end = pointAt(spiral, count - 1);
    const { positions } = thing(scene).mesh;
    expect(distance(pointAt(positions, positions.length / 3 - 1), end)).toBeLessThan(25);
    expect(scene.diagnostics.map((d) => d.severity)).toEqual(['info', 'warning']);
  });

  it('a corner that does not exist is refused', async () => {
    const bad = shown(LINES, [0, 0, 0, 1, 0, 0], (kit, p) => {
      p.setIndices(kit.ints('SCALAR', [0, 9]));
    });
    await expect(bad).rejects.toThrow(/a point or line wants vertex 9 of 2/);
  });
});
