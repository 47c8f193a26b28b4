import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fromAxisAngle } from '../../math/quat.ts';
import { length, sub, type Vec3 } from '../../math/vec3.ts';
import { makeObject, makeScene } from '../defaults.ts';
import { box } from '../mesh/primitives.ts';
import type { Motion, SceneObject } from '../types.ts';
import { validate } from '../validation/validate.ts';
import { fastestVertex, poseAt, vertexPosition } from './motion.ts';
import { retime } from './retime.ts';

const C = 10;
const mesh = box([1, 2, 3]);
const orientation = fromAxisAngle([1, 2, 3], 0.7);
const pose = { position: [1, 2, 3], orientation } as const;
const times = Float64Array.of(1, 2, 4);
const turned = fromAxisAngle([0, 0, 1], 1);
const poses = Float64Array.of(0, 0, 0, ...orientation, 2, 1, 0, ...turned, 5, 0, 3, ...orientation);
const points = [0, 1, 3].map((k) => mesh.positions.map((x, i) => x * (1 + 0.1 * k) + (i % 3 === 0 ? k : 0)));
const MOTIONS: readonly (readonly [Motion, SceneObject['authoredIn']])[] = [
  [{ kind: 'static', pose }, 'world'],
  [{ kind: 'uniform', pose, velocity: [3, -4, 1] }, 'world'],
  [{ kind: 'uniform', pose, velocity: [3, -4, 1] }, 'rest'],
  [{ kind: 'hyperbolic', pose, properAcceleration: [4, 1, 0], t0: 1.5 }, 'world'],
  [{ kind: 'hyperbolic', pose, properAcceleration: [4, 1, 0], t0: 1.5 }, 'rest'],
  [{ kind: 'sampled', times, poses }, 'world'],
  [{ kind: 'sampled', times, poses }, 'rest'],
  [{ kind: 'sampled-points', times, origin: [1, 1, 1], points }, 'world'],
  [{ kind: 'sampled-points', times, origin: [1, 1, 1], points, velocities: points.slice().reverse() }, 'world'],
];
const objects = MOTIONS.map(([motion, authoredIn], i) => makeObject({ path: `/m${i}`, mesh, motion, authoredIn }));
const scene = makeScene({ name: 'all', objects, startTime: 1, endTime: 4, hints: { openAt: 2 } });

const near = (a: Vec3, b: Vec3, tolerance = 1e-9) =>
  expect(length(sub(a, b))).toBeLessThan(tolerance * (1 + length(b)));

describe('retime', () => {
  it.each(
    objects.map(
      (object, i) =>
        [
          `${object.motion.kind}${'velocities' in object.motion ? ' along cubics' : ''}, ${object.authoredIn}`,
          i,
        ] as const,
    ),
  )('%s: run k times as fast, at a speed of light of k c, every point is where it was', (_, i) => {
    const speed = fc.double({ min: 0.02, max: 50, noNaN: true });
    const time = fc.double({ min: -20, max: 20, noNaN: true });
    fc.assert(
      fc.property(speed, time, time, fc.nat(mesh.positions.length / 3 - 1), (k, offset, tau, vertex) => {
        const next = retime(scene, { offset, speed: k });
        const t = scene.startTime + offset + (tau - scene.startTime) / k;
        // Velocities are f32, and so are what they are k times as great.
        const tolerance = 'velocities' in objects[i].motion ? 1e-6 : 1e-9;
        near(vertexPosition(next.objects[i], vertex, t, k * C), vertexPosition(objects[i], vertex, tau, C), tolerance);
      }),
    );
  });

  it('hyperbolic motion at low speed is the same motion in half the time at twice the speed', () => {
    const motion: Motion = { kind: 'hyperbolic', pose, properAcceleration: [2, 0, 0], t0: 0 };
    const slow = retime(
      { ...scene, startTime: 0, objects: [makeObject({ path: '/a', mesh, motion })] },
      { offset: 0, speed: 2 },
    );
    expect(poseAt(slow.objects[0].motion, 0.5, 1e9).position[0] - 1).toBeCloseTo(0.5 * 2 * 1 ** 2, 9);
  });

  it('retimes the time range, lifetimes, lights, cameras and the opening time too', () => {
    const lifetime = { birth: 2, death: Number.POSITIVE_INFINITY };
    const motion = { kind: 'sampled', times, poses } as const;
    const whole = {
      ...scene,
      objects: [makeObject({ path: '/a', mesh, lifetime })],
      lights: [
        { kind: 'sphere', path: '/l', motion, lifetime, radius: 1, color: [1, 1, 1] } as const,
        { kind: 'cylinder', path: '/m', motion, lifetime, radius: 1, length: 2, color: [1, 1, 1] } as const,
      ],
      cameras: [{ path: '/c', motion, fovY: 1 }],
    };
    const next = retime(whole, { offset: 10, speed: 2 });
    expect([next.startTime, next.endTime, next.hints.openAt]).toEqual([11, 12.5, 11.5]);
    expect(next.objects[0].lifetime).toEqual({ birth: 11.5, death: Number.POSITIVE_INFINITY });
    for (const light of next.lights)
      expect(light).toMatchObject({
        lifetime: { birth: 11.5 },
        motion: { times: Float64Array.of(11, 11.5, 12.5) },
      });
    expect(next.cameras[0].motion).toMatchObject({ times: Float64Array.of(11, 11.5, 12.5) });
    expect(retime(whole, { offset: 0, speed: 1 })).toBe(whole);
  });

  it('scales speeds, and superluminal results are found', () => {
    const before = fastestVertex(objects[5], C).speed;
    const next = retime(scene, { offset: 0, speed: 3 });
    expect(fastestVertex(next.objects[5], C).speed / before).toBeCloseTo(3, 9);
    const isFast = (code: string) => code === 'motion.superluminal';
    expect(
      validate(scene, C)
        .map(({ code }) => code)
        .filter(isFast),
    ).toEqual([]);
    expect(
      validate(next, C)
        .map(({ code }) => code)
        .filter(isFast).length,
    ).toBeGreaterThan(1);
  });
});
