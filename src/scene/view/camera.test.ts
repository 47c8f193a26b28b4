import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { IDENTITY, rotate } from '../../math/quat.ts';
import { length, sub, type Vec3 } from '../../math/vec3.ts';
import { makeObject, makeScene, restingAt } from '../defaults.ts';
import { box, sphere } from '../mesh/primitives.ts';
import { vertexPosition } from '../motion/motion.ts';
import type { Motion, Scene, SceneCamera, SceneObject } from '../types.ts';
import { framingCamera } from './camera.ts';

const C = 10;
const fc01 = fc.double({ min: -1, max: 1, noNaN: true });
const place = fc.tuple(fc01, fc01, fc01).map((x): Vec3 => [20 * x[0], 20 * x[1], 20 * x[2]]);

/** Where the corners of all objects are in a square picture, −1 … 1, at times [s]; and how far in front of the camera. */
function seen(camera: SceneCamera, { objects }: Scene, times: readonly number[]) {
  const { pose } = camera.motion as Extract<Motion, { kind: 'static' }>;
  const axis = (d: Vec3): Vec3 => rotate(pose.orientation, d);
  const [right, top, back] = [axis([1, 0, 0]), axis([0, 1, 0]), axis([0, 0, 1])];
  const along = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const all = objects.flatMap((object) =>
    times.flatMap((t) =>
      Array.from({ length: object.mesh.positions.length / 3 }, (_, i) =>
        sub(vertexPosition(object, i, t, C), pose.position),
      ),
    ),
  );
  const half = Math.tan(camera.fovY / 2);
  return all.map((d) => {
    const depth = -along(d, back);
    return { x: along(d, right) / (half * depth), y: along(d, top) / (half * depth), depth };
  });
}

/** The outline is within 9/10 of the picture, and touches two opposite sides of that. */
function expectFramed(scene: Scene, times: readonly number[]): void {
  const points = seen(framingCamera(scene), scene, times);
  const sides = (axis: 'x' | 'y'): number[] => [-1, 1].map((sign) => Math.max(...points.map((p) => sign * p[axis])));
  const [left, right, bottom, top] = [...sides('x'), ...sides('y')];
  for (const { depth } of points) expect(depth).toBeGreaterThan(0);
  for (const side of [left, right, bottom, top]) expect(side).toBeLessThan(0.9 + 1e-6);
  expect(Math.max(Math.min(left, right), Math.min(bottom, top))).toBeGreaterThan(0.9 - 1e-6);
}

const cube = (motion: Motion, path = '/Cube'): SceneObject => makeObject({ path, mesh: box([2, 3, 1]), motion });

describe('the camera of scenes without one', () => {
  it('has the outline of what rests in nine tenths of its picture', () => {
    fc.assert(
      fc.property(fc.array(place, { minLength: 1, maxLength: 4 }), fc.constantFrom('Y', 'Z'), (places, upAxis) => {
        const objects = places.map((at, k) => cube(restingAt(at), `/Cube${k}`));
        expectFramed(makeScene({ name: 's', objects, upAxis: upAxis as 'Y' | 'Z' }), [0]);
      }),
      { numRuns: 50 },
    );
  });

  it('and of what moves, during the whole animation', () => {
    fc.assert(
      fc.property(place, place, (from, v) => {
        const velocity: Vec3 = [v[0] / 4, v[1] / 4, v[2] / 4];
        const flying = cube({ kind: 'uniform', pose: { position: from, orientation: IDENTITY }, velocity });
        expectFramed(
          makeScene({
            name: 's',
            objects: [flying, cube(restingAt([0, 0, 0]))],
            endTime: 6,
            hints: { speedOfLight: C },
          }),
          [0, 6],
        );
      }),
      { numRuns: 50 },
    );
  });

  it('is as far from a ball as its tangents', () => {
    const ball = makeObject({ path: '/Ball', mesh: sphere(3, { segments: 200 }), motion: restingAt([5, 1, 2]) });
    const camera = framingCamera(makeScene({ name: 's', objects: [ball] }));
    const { pose } = camera.motion as Extract<Motion, { kind: 'static' }>;
    expect(length(sub(pose.position, [5, 1, 2]))).toBeCloseTo(
      3 / Math.sin(Math.atan(0.9 * Math.tan(camera.fovY / 2))),
      2,
    );
  });

  it('has a place where there is nothing, and before a single point', () => {
    const empty = framingCamera(makeScene({ name: 's', objects: [] }));
    const point = makeObject({ path: '/P', mesh: { ...box([0, 0, 0]) }, motion: restingAt([1, 2, 3]) });
    const near = framingCamera(makeScene({ name: 's', objects: [point] }));
    const at = ({ motion }: SceneCamera): Vec3 => (motion as Extract<Motion, { kind: 'static' }>).pose.position;
    expect(length(at(empty))).toBeGreaterThan(2);
    expect(length(sub(at(near), [1, 2, 3]))).toBeCloseTo(2e-3, 9);
  });
});
