import { describe, expect, it } from 'vitest';
import { inEnglish } from '../../messages/message.ts';
import { FOREVER, makeMaterial, makeObject, makeScene, restingAt } from '../../scene/defaults.ts';
import { box, grid } from '../../scene/mesh/primitives.ts';
import { pointsAt } from '../../scene/streaming/samplePoints.ts';
import type { Mesh, SampledPointsMotion, Scene } from '../../scene/types.ts';
import { sanitizeScene } from './sanitize.ts';

const NaN32 = Number.NaN;
const mesh = box([1, 1, 1]);
const damaged = (given: Partial<Mesh>): Mesh => ({ ...mesh, ...given });
const at = (numbers: Float32Array, index: number, value: number): Float32Array => numbers.with(index, value);
const sceneOf = (...objects: Parameters<typeof makeObject>[0][]): Scene =>
  makeScene({ name: 'a.usda', objects: objects.map((object) => makeObject(object)) });

describe('sanitizing a scene', () => {
  it('returns a valid scene unchanged', () => {
    const scene = sceneOf({ path: '/A', mesh });
    expect(sanitizeScene(scene)).toBe(scene);
  });

  it('removes only the triangles of non-finite points', () => {
    const plane = grid(2, 2, 2, 2);
    const broken = { ...plane, positions: at(plane.positions, 0, Number.POSITIVE_INFINITY) };
    const { objects, diagnostics } = sanitizeScene(sceneOf({ path: '/A', mesh: broken }, { path: '/B', mesh }));
    const uses = [...plane.indices].filter((vertex) => vertex === 0).length;
    expect(objects[0].mesh.indices).toHaveLength(plane.indices.length - 3 * uses);
    expect(objects[0].mesh.indices).not.toContain(0);
    expect(objects[0].mesh.groups.reduce((sum, { count }) => sum + count, 0)).toBe(objects[0].mesh.indices.length);
    expect(objects[1].mesh).toBe(mesh);
    expect(diagnostics).toMatchObject([{ code: 'file.not-finite', place: 'a.usda</A>', severity: 'warning' }]);
    expect(inEnglish(diagnostics[0].message)).toContain(`the place of 1 of ${plane.positions.length / 3} points`);
  });

  it('removes points that are non-finite at one sample', () => {
    const points = [mesh.positions, at(mesh.positions, 4, NaN32)];
    const motion: SampledPointsMotion = {
      kind: 'sampled-points',
      times: Float64Array.of(0, 1),
      origin: [0, 0, 0],
      points,
    };
    const { objects } = sanitizeScene(sceneOf({ path: '/A', mesh, motion }));
    expect(objects[0].mesh.indices).not.toContain(1);
    const sound = objects[0].motion as SampledPointsMotion;
    for (const k of motion.times.keys()) expect(pointsAt(sound, k).every(Number.isFinite)).toBe(true);
  });

  it('replaces invalid normals', () => {
    const { objects } = sanitizeScene(sceneOf({ path: '/A', mesh: damaged({ normals: at(mesh.normals, 1, NaN32) }) }));
    // A box's corner vertex has the normal of its face, and no other triangle.
    for (let i = 0; i < mesh.normals.length; i++) expect(objects[0].mesh.normals[i]).toBeCloseTo(mesh.normals[i], 6);
  });

  it('preserves sharing of meshes', () => {
    const broken = damaged({ uvs: at(mesh.uvs, 0, NaN32) });
    const { objects } = sanitizeScene(sceneOf({ path: '/A', mesh: broken }, { path: '/B', mesh: broken }));
    expect(objects[0].mesh).toBe(objects[1].mesh);
    expect(objects[0].mesh.uvs[0]).toBe(0);
  });

  it('removes objects, lights and materials with non-finite values', () => {
    const nowhere = { ...restingAt([0, 0, 0]), kind: 'uniform', velocity: [NaN32, 0, 0] } as const;
    const lamp = {
      kind: 'disk',
      motion: restingAt([0, 0, 0]),
      lifetime: FOREVER,
      radius: 1,
      color: [1, 1, 1],
    } as const;
    const sound = sanitizeScene({
      ...sceneOf({ path: '/A', mesh, motion: nowhere }, { path: '/B', mesh }),
      materials: [makeMaterial({ name: 'odd', roughness: NaN32 })],
      lights: [
        { kind: 'dome', path: '/Sky', color: [1, Number.POSITIVE_INFINITY, 1] },
        { kind: 'dome', path: '/Dusk', color: [1, 1, 1], gradient: { horizon: [NaN32, 0, 0], ground: [0, 0, 0] } },
        { ...lamp, path: '/Wide', radius: NaN32 },
        { ...lamp, path: '/Bent', shaping: { inner: 0, outer: NaN32, focus: 0 } },
      ],
      endTime: Number.POSITIVE_INFINITY,
    });
    expect(sound.objects.map(({ path }) => path)).toEqual(['/B']);
    expect(sound.lights).toEqual([]);
    expect(sound.materials[0].roughness).toBe(0.6);
    expect(sound.endTime).toBe(0);
    expect(sound.diagnostics).toHaveLength(7);
  });
});
