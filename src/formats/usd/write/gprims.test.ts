import { describe, expect, it } from 'vitest';
import { settingsFor, tracedScene, viewFrom } from '../../../../tests/support/rays.ts';
import { fromParts, type Mat4 } from '../../../math/mat4.ts';
import { fromAxisAngle, type Quat, toMatrix } from '../../../math/quat.ts';
import { normalize, type Vec3 } from '../../../math/vec3.ts';
import { rayToward } from '../../../reference/camera/lensRay.ts';
import { nearestHit } from '../../../reference/intersection/tracedScene.ts';
import { surfaceAt } from '../../../reference/materials/surface.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../scene/defaults.ts';
import { transformMesh } from '../../../scene/mesh/meshOps.ts';
import { type Axis, capsule, cone, cylinder, sphere } from '../../../scene/mesh/primitives.ts';
import type { Mesh, Motion, Scene, SceneObject } from '../../../scene/types.ts';
import { memorySource } from '../../files/fileSource.ts';
import { readUsd } from '../read.ts';
import { writeUsda, writeUsdc } from './writeUsd.ts';

const C = 10;
const tilted = { position: [0.3, -0.4, -6] as Vec3, orientation: fromAxisAngle([1, 2, -1], 0.7) };
const resting: Motion = { kind: 'static', pose: tilted };
const flying: Motion = { kind: 'uniform', pose: tilted, velocity: [3, 0, -2] };
const between = (from: Quat, to: Quat): Motion => ({
  kind: 'sampled',
  times: Float64Array.of(-4, 4),
  poses: Float64Array.from([-1, 0, -6, ...from, 1, 0.2, -6, ...to]),
});
const gliding = between(tilted.orientation, tilted.orientation);
const turning = between(tilted.orientation, fromAxisAngle([1, 2, 2], 1.2));
const rocket: Motion = { kind: 'hyperbolic', pose: tilted, properAcceleration: [2, 0, 0], t0: 0.25 };

const linear = (l: readonly number[]): Mat4 => fromParts(l as never, [0, 0, 0]);
const STRETCH = linear([1.5, 0.2, 0, 0.2, 0.7, 0, 0, 0, 1]);
const MIRROR = linear([-1, 0, 0, 0, 1, 0, 0, 0, 1]);
const TURNED = fromParts(toMatrix(fromAxisAngle([3, 1, 0], 0.9)), [0.5, 0, 0.25]);

const sceneOf = (mesh: Mesh, motion: Motion, rest: Partial<SceneObject> = {}, metersPerUnit = 1): Scene =>
  makeScene({
    name: 'round.usda',
    metersPerUnit,
    materials: [makeMaterial({ name: '/Looks/A' }), makeMaterial({ name: '/Looks/B' })],
    objects: [{ ...makeObject({ path: '/World/Round', mesh, motion }), ...rest }],
  });

const typeOf = (scene: Scene): string => /def (\w+) "Round"/.exec(writeUsda(scene))![1];

const reread = (scene: Scene): Promise<readonly [Scene, Scene]> => {
  const files = { 'a.usda': new TextEncoder().encode(writeUsda(scene)), 'a.usdc': writeUsdc(scene) };
  return Promise.all([readUsd(memorySource(files), 'a.usda'), readUsd(memorySource(files), 'a.usdc')]);
};

/** What 13 × 13 rays see: place, time, normal and texture coordinates. */
function picture({ objects }: Scene): readonly (readonly number[])[] {
  const scene = tracedScene(objects, C);
  const rays = Array.from({ length: 169 }, (_, i): Vec3 => [(i % 13) / 20 - 0.3, Math.floor(i / 13) / 20 - 0.3, -1]);
  return rays.map((n) => {
    const hit = nearestHit(scene, rayToward(viewFrom(), settingsFor('light-cone', C), normalize(n)));
    if (!hit) return [];
    const { normal, uv } = surfaceAt(scene, hit);
    return [...hit.position, hit.time, ...normal, ...uv];
  });
}

function expectSamePicture(a: Scene, b: Scene): void {
  const [before, after] = [picture(a), picture(b)];
  expect(before.filter((seen) => seen.length > 0).length).toBeGreaterThan(10);
  expect(after).toEqual(before.map((seen) => seen.map((x) => expect.closeTo(x, 5))));
}

describe('round solids are written as prims of UsdGeom, and look the same when they are read', () => {
  const shapes: readonly (readonly [type: string, make: (axis: Axis, segments: number) => Mesh])[] = [
    ['Sphere', (axis, segments) => sphere(1.2, { axis, segments })],
    ['Cylinder', (axis, segments) => cylinder(0.8, 2, { axis, segments })],
    ['Cone', (axis, segments) => cone(1, 2.2, { axis, segments })],
    ['Capsule', (axis, segments) => capsule(0.7, 1.1, { axis, segments })],
  ];
  const cases = shapes.flatMap(([type, make]) =>
    (['X', 'Y', 'Z'] as const).map((axis, i) => [type, axis, make(axis, [64, 40, 27][i])] as const),
  );

  it.each(cases)('%s about %s', async (type, _, mesh) => {
    for (const motion of [resting, gliding, turning]) {
      const scene = sceneOf(mesh, motion);
      expect(typeOf(scene)).toBe(type);
      for (const back of await reread(scene)) {
        expect(back.diagnostics.filter(({ code }) => code !== 'usd.between-samples')).toEqual([]);
        const { mesh: after } = back.objects[0];
        expect(after.quadric).toEqual(mesh.quadric);
        expect([after.positions, after.indices, after.uvs]).toEqual([mesh.positions, mesh.indices, mesh.uvs]);
        // Turns are read as more samples than are written.
        if (motion !== turning) expectSamePicture(scene, back);
      }
    }
  });

  const moving: readonly (readonly [string, Mesh, Motion, Partial<SceneObject>, number])[] = [
    ['stretched, gliding', transformMesh(sphere(1, { axis: 'Y' }), STRETCH), gliding, {}, 1],
    ['flying, as at rest', transformMesh(cone(1, 2, { axis: 'X' }), STRETCH), flying, { authoredIn: 'rest' }, 1],
    ['accelerating, in centimetres', capsule(0.5, 1), rocket, {}, 0.01],
    ['mirrored, at rest', transformMesh(cylinder(0.8, 2), MIRROR), resting, {}, 1],
    ['moved and turned, in centimetres', transformMesh(cylinder(0.8, 2), TURNED), resting, {}, 0.01],
    ['of other bands', sphere(1, { segments: 48, rings: 11 }), resting, {}, 1],
    ['that is born and dies', sphere(1), resting, { lifetime: { birth: -2, death: 3 } }, 1],
    ['seen from both sides', { ...sphere(1), doubleSided: true }, resting, {}, 1],
  ];
  it.each(moving)('%s', async (_, mesh, motion, rest, unit) => {
    const scene = sceneOf(mesh, motion, rest, unit);
    expect(typeOf(scene)).not.toBe('Mesh');
    for (const back of await reread(scene)) {
      const [{ lifetime, authoredIn, mesh: after, motion: path }] = back.objects;
      expect(after.quadric).toMatchObject({ segments: mesh.quadric!.segments, rings: mesh.quadric!.rings });
      expect([lifetime, authoredIn, after.doubleSided, path.kind]).toEqual([
        scene.objects[0].lifetime,
        scene.objects[0].authoredIn,
        mesh.doubleSided,
        motion.kind,
      ]);
      expectSamePicture(scene, back);
    }
  });
});

describe('what a prim of UsdGeom cannot say stays a mesh', () => {
  const ball = sphere(1);
  const half = ball.indices.length / 2;
  const two = [
    { start: 0, count: half, material: 0 },
    { start: half, count: half, material: 1 },
  ];
  const meshes: readonly (readonly [string, Mesh, Motion])[] = [
    ['of two materials', { ...ball, groups: two }, resting],
    ['coloured', { ...ball, colors: ball.positions.map(Math.abs) }, resting],
    ['with other texture coordinates', { ...ball, uvs: ball.uvs.map((x) => 2 * x) }, resting],
    ['with other normals', { ...ball, normals: ball.normals.map((x) => -x) }, resting],
    ['with other points', { ...ball, positions: ball.positions.map((x) => 1.001 * x) }, resting],
    ['finer than may be asked for', sphere(1, { segments: 300, rings: 8 }), resting],
    ['of few segments', sphere(1, { segments: 12 }), resting],
    ['turned in the frame of what moves', transformMesh(ball, TURNED), flying],
    ['mirrored, moving', transformMesh(ball, MIRROR), flying],
  ];
  it.each(meshes)('%s', (_, mesh, motion) => expect(typeOf(sceneOf(mesh, motion))).toBe('Mesh'));

  it('whose points move', () => {
    const points = [ball.positions, ball.positions.map((x) => 2 * x)];
    const motion: Motion = { kind: 'sampled-points', times: Float64Array.of(0, 1), origin: [0, 0, 0], points };
    expect(typeOf(sceneOf(ball, motion))).toBe('Mesh');
  });
});

it.each(['2', '1e9', '40.5'])('leaves out %s segments, and says so', async (segments) => {
  const text = writeUsda(sceneOf(sphere(1, { segments: 40 }), restingAt([0, 0, 0]))).replace(
    'int slowlight:segments = 40',
    `double slowlight:segments = ${segments}`,
  );
  const { objects, diagnostics } = await readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda');
  expect(objects[0].mesh.quadric?.segments).toBe(64);
  expect(diagnostics).toMatchObject([{ code: 'usd.slowlight', place: 'a.usda</World/Round>' }]);
});
