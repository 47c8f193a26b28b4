import { describe, expect, it } from 'vitest';
import { leftInFile } from '../../../tests/support/streamed.ts';
import { IDENTITY } from '../../math/quat.ts';
import { add, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { makeObject, makeScene, restingAt } from '../defaults.ts';
import { box } from '../mesh/primitives.ts';
import type { Motion, SampledPointsMotion, Scene } from '../types.ts';
import { type Flight, fly, tooLargeToFly } from './fly.ts';
import { fastestVertex, poseAt, vertexPosition } from './motion.ts';

const C = 10;
const mesh = box([2, 2, 2]);
const count = mesh.positions.length / 3;
const times = Float64Array.of(0, 2);
const sampled: Motion = { kind: 'sampled', times, poses: Float64Array.of(0, 0, 0, ...IDENTITY, 4, 0, 0, ...IDENTITY) };
const points = [0, 1].map((k) => mesh.positions.map((x) => x * (1 + 0.5 * k)));
const deforming: Motion = { kind: 'sampled-points', times, origin: [0, 5, 0], points };
const lamp = {
  kind: 'sphere',
  path: '/car/lamp',
  motion: restingAt([0, 0, 1]),
  lifetime: { birth: 0, death: 1 },
  radius: 0,
  color: [1, 1, 1],
} as const;
const window = { ...lamp, kind: 'rect', path: '/car/window', width: 2, height: 1 } as const;
const scene = makeScene({
  name: 'all',
  endTime: 2,
  objects: [
    makeObject({ path: '/car/body', mesh, motion: restingAt([-3, 0, 0]) }),
    makeObject({ path: '/car/wheel', mesh, motion: restingAt([3, 0, 0]) }),
    makeObject({ path: '/carpet', mesh }),
    makeObject({ path: '/moving', mesh, motion: sampled }),
    makeObject({ path: '/soft', mesh, motion: deforming }),
  ],
  lights: [lamp, window],
});
const flight = (path: string, more: Partial<Flight> = {}): Flight => ({
  path,
  beta: [0.8, 0, 0],
  at: 1,
  authoredIn: 'world',
  ...more,
});
const origin = ({ objects }: Scene, path: string, t: number): Vec3 =>
  poseAt(objects.find((object) => object.path === path)!.motion, t, C).position;

describe('fly', () => {
  it('an object and its descendants pass their positions at the given time, at βc; nothing else moves', () => {
    const flown = fly(scene, flight('/car'), C);
    for (const path of ['/car/body', '/car/wheel'])
      for (const t of [-5, 1, 3])
        expect(origin(flown, path, t)).toEqual(add(origin(scene, path, 1), [0.8 * C * (t - 1), 0, 0]));
    expect(flown.objects[2]).toBe(scene.objects[2]);
    for (const light of flown.lights) expect(light).toMatchObject({ motion: { kind: 'uniform', velocity: [8, 0, 0] } });
  });

  it('a moving object continues from its pose at that time', () => {
    const flown = fly(scene, flight('/moving', { at: 0.5 }), C);
    expect(origin(flown, '/moving', 0.5)).toEqual([1, 0, 0]);
    expect(origin(flown, '/moving', 1.5)).toEqual([9, 0, 0]);
  });

  it('parts given as the rest shape are contracted together: a distance of 6 m becomes 6/γ', () => {
    const flown = fly(scene, flight('/car', { authoredIn: 'rest' }), C);
    const gap = sub(origin(flown, '/car/wheel', 1), origin(flown, '/car/body', 1));
    expect(gap[0]).toBeCloseTo(6 * 0.6, 12);
    const corner = Array.from({ length: count }, (_, i) => vertexPosition(flown.objects[0], i, 1, C)[0]);
    expect(Math.max(...corner) - Math.min(...corner)).toBeCloseTo(2 * 0.6, 6);
  });

  it('streamed samples move like those in memory', () => {
    const normals = points.map(() => mesh.normals);
    const still = { ...deforming, normals } as SampledPointsMotion;
    const carried = [still, leftInFile(still)].map((motion) => {
      const soft = makeScene({ name: 'soft', endTime: 2, objects: [makeObject({ path: '/soft', mesh, motion })] });
      return fly(soft, flight('/soft'), C).objects[0];
    });
    for (const t of [-3, 0, 0.7, 2, 9])
      for (const i of [0, 5, 11]) {
        const [known, left] = carried.map((object) => vertexPosition(object, i, t, C));
        expect(length(sub(left, known))).toBeLessThan(1e-5);
      }
    const [known, left] = carried.map((object) => fastestVertex(object, C));
    // Of each piece only the greatest displacement is known, not its direction.
    expect(left.speed).toBeGreaterThanOrEqual(known.speed - 1e-6);
    expect(left.speed).toBeLessThan(known.speed + 0.5 * 3 ** 0.5);
  });

  it('a deforming object keeps deforming in flight, also before and after its samples', () => {
    const flown = fly(scene, flight('/soft'), C).objects[4];
    for (const t of [-3, 0, 0.5, 1, 2, 10])
      for (let i = 0; i < count; i++) {
        const was = vertexPosition(scene.objects[4], i, t, C);
        const moved = sub(vertexPosition(flown, i, t, C), add(was, scale([8, 0, 0], t - 1)));
        expect(length(moved)).toBeLessThan(1e-4);
      }
    // Its own 0.5 m/s outwards, added.
    expect(fastestVertex(flown, C).speed).toBeGreaterThan(8.2);
  });

  it('so does an object that deforms along cubics', () => {
    const outwards = (by: number) => mesh.positions.map((x) => by * x);
    const soft = { ...scene.objects[4], motion: { ...deforming, velocities: [outwards(0.1), outwards(0.6)] } };
    const flown = fly({ ...scene, objects: [soft] }, flight('/soft'), C).objects[0];
    for (const t of [-3, -1e-3, 0, 0.5, 1, 1.7, 2, 2.001, 10])
      for (let i = 0; i < count; i++) {
        const was = vertexPosition(soft, i, t, C);
        const moved = sub(vertexPosition(flown, i, t, C), add(was, scale([8, 0, 0], t - 1)));
        expect(length(moved)).toBeLessThan(1e-4);
      }
  });

  it('at speed 0 it stops where it is at that time', () => {
    const flown = fly(scene, flight('/moving', { beta: [0, 0, 0] }), C);
    expect(flown.objects[3].motion).toEqual({ kind: 'static', pose: { position: [2, 0, 0], orientation: IDENTITY } });
  });

  it('reports objects with too many samples', () => {
    const many = { ...deforming, times: new Float64Array(1e6) } as Motion;
    const large = { ...scene, objects: [{ ...scene.objects[4], motion: many }] };
    expect(tooLargeToFly(scene, '/soft')).toEqual([]);
    expect(tooLargeToFly(large, '/soft')).toEqual(['/soft']);
    expect(tooLargeToFly(large, '/car')).toEqual([]);
  });
});
