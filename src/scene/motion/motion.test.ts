import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fromAxisAngle, IDENTITY, rotate } from '../../math/quat.ts';
import { add, distance, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { emissionTime } from '../../physics/worldLines/lightCone.ts';
import { boundingBox, boundingSphere } from '../bounds/bounds.ts';
import { emissionWindow, sceneBounds } from '../bounds/sceneBounds.ts';
import { makeObject, makeScene, restingAt } from '../defaults.ts';
import { pointAt } from '../mesh/polygons.ts';
import { box, sphere } from '../mesh/primitives.ts';
import type { Motion, Pose, SampledMotion, SceneCamera, SceneObject } from '../types.ts';
import { lookAtOrientation, observerFromCamera } from '../view/camera.ts';
import { fastestVertex, poseAt, restToWorld, vertexPosition, vertexPositions, vertexWorldLine } from './motion.ts';
import { resampleRotation, sampleMotion } from './resample.ts';

const c = 10;
const cube = (motion: Motion, given: Partial<SceneObject> = {}): SceneObject =>
  makeObject({ path: '/Cube', mesh: box([2, 2, 2]), motion, ...given });
const vertices = (object: SceneObject): number[] => [...Array(object.mesh.positions.length / 3).keys()];
const sampled = (times: readonly number[], poseOf: (t: number) => Pose): SampledMotion => ({
  kind: 'sampled',
  times: Float64Array.from(times),
  poses: Float64Array.from(times.flatMap((t) => [...poseOf(t).position, ...poseOf(t).orientation])),
});
const speed = fc.double({ min: 0, max: 0.999, noNaN: true });

describe('world lines of vertices', () => {
  it('a rest-authored uniform mover is contracted along its velocity only', () => {
    fc.assert(
      fc.property(speed, fc.double({ min: -20, max: 20, noNaN: true }), (beta, t) => {
        const velocity = scale([0.6, 0, 0.8], beta * c);
        const pose = { position: [1, 2, 3] as Vec3, orientation: fromAxisAngle([1, 1, 0], 0.7) };
        const object = cube({ kind: 'uniform', pose, velocity }, { authoredIn: 'rest' });
        for (const i of vertices(object)) {
          const offset = sub(vertexPosition(object, i, t, c), add(pose.position, scale(velocity, t)));
          const atRest = rotate(pose.orientation, pointAt(object.mesh.positions, i));
          const along = dot(atRest, [0.6, 0, 0.8]);
          expect(dot(offset, [0.6, 0, 0.8])).toBeCloseTo(along * Math.sqrt(1 - beta * beta), 9);
          expect(offset[1]).toBeCloseTo(atRest[1], 9);
        }
      }),
      { numRuns: 25 },
    );
  });

  it('a Born-rigid body keeps its length in each momentary rest frame', () => {
    const motion: Motion = {
      kind: 'hyperbolic',
      pose: { position: [4, 0, 0], orientation: IDENTITY },
      properAcceleration: [20, 0, 0],
      t0: 1,
    };
    const object = cube(motion, { authoredIn: 'rest' });
    // On x = X cosh η, ct = X sinh η each point has its own X, measured from the horizon, and equal η are simultaneous for the body.
    const horizon = 4 - (c * c) / 20;
    for (const eta of [-1.5, 0.3, 2]) {
      for (const i of vertices(object)) {
        const X = 4 + object.mesh.positions[3 * i] - horizon;
        const [x] = vertexPosition(object, i, 1 + (X * Math.sinh(eta)) / c, c);
        expect(x).toBeCloseTo(horizon + X * Math.cosh(eta), 9);
      }
    }
    const asWritten = cube(motion);
    const [a, b] = [0, 1].map((i) => vertexPosition(asWritten, i, 7, c));
    expect(distance(a, b)).toBeCloseTo(2, 9);
  });

  it('a vertex moves straight between samples, and is at rest before and after', () => {
    const turn = (t: number): Pose => ({ position: [t, 0, 0], orientation: fromAxisAngle([0, 0, 1], t) });
    const object = cube(sampled([1, 2], turn));
    for (const i of vertices(object)) {
      const ends = [1, 2].map((t) =>
        add(turn(t).position, rotate(turn(t).orientation, pointAt(object.mesh.positions, i))),
      );
      expect(
        distance(vertexPosition(object, i, 1.25, c), add(scale(ends[0], 0.75), scale(ends[1], 0.25))),
      ).toBeLessThan(1e-12);
      expect(vertexPosition(object, i, -5, c)).toEqual(vertexPosition(object, i, 1, c));
      expect(distance(vertexPosition(object, i, 9, c), ends[1])).toBeLessThan(1e-12);
    }
    expect(distance(poseAt(object.motion, 1.5, c).position, [1.5, 0, 0])).toBeLessThan(1e-12);
    expect(poseAt(object.motion, 1.5, c).orientation[2]).toBeCloseTo(Math.sin(0.75), 12);
  });

  it('a rest-authored sampled object is contracted, equally as world line and as points', () => {
    const object = cube(
      sampled([0, 1, 2], (t) => ({ position: [6 * t, 0, 0], orientation: IDENTITY })),
      { authoredIn: 'rest' },
    );
    const points = restToWorld(object, c);
    expect(points.authoredIn).toBe('world');
    for (const i of vertices(object)) {
      const [x] = vertexPosition(object, i, 0.5, c);
      expect(x - 3).toBeCloseTo(0.8 * object.mesh.positions[3 * i], 9);
      expect(distance(vertexPosition(points, i, 1.5, c), vertexPosition(object, i, 1.5, c))).toBeLessThan(1e-5);
    }
    expect(restToWorld(cube(restingAt([0, 0, 0])), c).motion.kind).toBe('static');
  });
});

describe('vertexPositions', () => {
  it('equals vertexPosition of every vertex, for every kind of motion, before, between and after the samples', () => {
    const pose: Pose = { position: [1, 2, 3], orientation: fromAxisAngle([1, 1, 0], 0.7) };
    const flat = box([2, 2, 2]).positions;
    const moving = (t: number): Pose => ({ position: [3 * t, t * t, 0], orientation: fromAxisAngle([0, 1, 1], t) });
    const motions: Motion[] = [
      { kind: 'static', pose },
      { kind: 'uniform', pose, velocity: [3, 4, 0] },
      { kind: 'hyperbolic', pose, properAcceleration: [5, 0, 5], t0: 1 },
      sampled([0, 1, 1.5], moving),
      {
        kind: 'sampled-points',
        times: Float64Array.of(0, 2),
        origin: [1, 1, 1],
        points: [flat, flat.map((x) => 2 * x)],
      },
    ];
    for (const motion of motions)
      for (const authoredIn of ['world', 'rest'] as const)
        for (const t of [-1, 0, 0.3, 1.2, 9]) {
          const object = cube(motion, { authoredIn });
          const all = vertexPositions(object, t, c);
          for (const i of vertices(object))
            expect(distance(pointAt(all, i), vertexPosition(object, i, t, c))).toBeLessThan(1e-9);
        }
  });
});

describe('resampling', () => {
  const turning = (t: number): Pose => ({ position: [0, 0, 0], orientation: fromAxisAngle([0.6, 0, 0.8], t) });

  it('keeps the chord error under the tolerance, with no more samples than that needs', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0.01, max: 3, noNaN: true }),
        fc.double({ min: 0.1, max: 50, noNaN: true }),
        fc.double({ min: 1e-3, max: 0.05, noNaN: true }),
        (angle, radius, relative) => {
          const tolerance = radius * relative;
          const ends = sampled([0, 1], (t) => turning(angle * t));
          const { times } = resampleRotation(ends.times, ends.poses, radius, tolerance);
          const n = times.length - 1;
          const sagitta = (pieces: number) => radius * (1 - Math.cos(angle / pieces / 2));
          expect(sagitta(n)).toBeLessThanOrEqual(tolerance * (1 + 1e-6));
          if (n > 1) expect(sagitta(n - 1)).toBeGreaterThan(tolerance * (1 - 1e-6));
        },
      ),
    );
  });

  it.each([0.5, 1, 4, 12])('follows %d whole turns within one interval', (turns) => {
    const at = (t: number) => turning(2 * Math.PI * turns * t);
    const radius = 3;
    const { times, poses } = sampleMotion(at, [0, 1], radius, 0.01);
    const object = makeObject({
      path: '/Ball',
      mesh: sphere(radius, { segments: 8 }),
      motion: { kind: 'sampled', times, poses },
    });
    for (let k = 0; k <= 200; k++) {
      const places = vertexPositions(object, k / 200, c);
      for (const i of vertices(object)) {
        const true_ = rotate(at(k / 200).orientation, pointAt(object.mesh.positions, i));
        expect(distance(pointAt(places, i), true_)).toBeLessThan(0.0101);
      }
    }
  });

  it('adds no samples to straight motion', () => {
    expect([
      ...sampleMotion((t) => ({ position: [t, 2 * t, 0], orientation: IDENTITY }), [0, 3], 5, 1e-6).times,
    ]).toEqual([0, 3]);
  });
});

describe('fastest', () => {
  it('of a rolling wheel is that of the chord at the top of the rim, not of the axle', () => {
    const [radius, step] = [1, 0.1];
    const object = makeObject({
      path: '/Wheel',
      mesh: sphere(radius, { segments: 64, axis: 'Z' }),
      motion: sampled([0, step], (t) => ({ position: [4 * t, 0, 0], orientation: fromAxisAngle([0, 0, 1], -4 * t) })),
    });
    const found = fastestVertex(object, c);
    // The displacement of a point at angle φ: 4 step + the chord 2 sin(2 step) at its best alignment.
    expect(found.speed).toBeLessThanOrEqual((4 * step + 2 * Math.sin(2 * step)) / step + 1e-9);
    expect(found.speed).toBeGreaterThan(0.998 * ((4 * step + 2 * Math.sin(2 * step)) / step));
    expect(found).toMatchObject({ from: 0, to: step });
    expect(object.mesh.positions[3 * found.vertex + 1]).toBeGreaterThan(0.97);
  });

  it('agrees with a search over every vertex of every piece', () => {
    fc.assert(
      fc.property(
        fc.array(
          fc.tuple(
            fc.double({ min: -3, max: 3, noNaN: true }),
            fc.double({ min: -3, max: 3, noNaN: true }),
            fc.double({ min: -3, max: 3, noNaN: true }),
          ),
          { minLength: 2, maxLength: 8 },
        ),
        (ways) => {
          const motion = sampled([...ways.keys()], (t) => ({
            position: ways[t],
            orientation: fromAxisAngle([1, 2, ways[t][0]], ways[t][1]),
          }));
          const object = cube(motion);
          const speeds = ways
            .slice(1)
            .map((_, k) =>
              Math.max(
                ...vertices(object).map((i) =>
                  distance(vertexPosition(object, i, k, c), vertexPosition(object, i, k + 1, c)),
                ),
              ),
            );
          expect(fastestVertex(object, c).speed).toBeCloseTo(Math.max(...speeds), 9);
          expect(fastestVertex(object, c, [0, 0], 1e3).speed).toBe(0);
        },
      ),
      { numRuns: 40 },
    );
  });

  it('of other motions agrees with closed forms', () => {
    expect(fastestVertex(cube(restingAt([0, 0, 0])), c).speed).toBe(0);
    const pose: Pose = { position: [0, 0, 0], orientation: IDENTITY };
    expect(fastestVertex(cube({ kind: 'uniform', pose, velocity: [3, 4, 0] }), c).speed).toBe(5);
    const accelerated = fastestVertex(
      cube({ kind: 'hyperbolic', pose, properAcceleration: [10, 0, 0], t0: 0 }),
      c,
      [0, 3],
    );
    expect(accelerated.speed).toBeCloseTo(30 / Math.sqrt(10), 9);
    const flat = new Float32Array(72).fill(1);
    const points = fastestVertex(
      cube({
        kind: 'sampled-points',
        times: Float64Array.of(0, 2),
        origin: [0, 0, 0],
        points: [flat, flat.map((x) => 3 * x)],
      }),
      c,
    );
    expect(points.speed).toBeCloseTo(Math.sqrt(3), 6);
  });
});

describe('bounds', () => {
  it('a box and a sphere contain their points; non-finite numbers are skipped', () => {
    const { center, radius } = boundingSphere(box([2, 4, 4]).positions);
    expect(center).toEqual([0, 0, 0]);
    expect(radius).toBeCloseTo(3, 9);
    expect(boundingBox([1, 2, 3, Number.NaN, 5, 6, -1, 0, 9])).toEqual({ min: [-1, 0, 3], max: [1, 5, 9] });
    expect(boundingBox([])).toBeUndefined();
  });

  it('a scene’s box is that of the objects that exist at the time', () => {
    const pose: Pose = { position: [5, 0, 0], orientation: IDENTITY };
    const objects = [
      cube({ kind: 'uniform', pose, velocity: [1, 0, 0] }),
      cube(restingAt([0, 50, 0]), { lifetime: { birth: 3, death: 4 } }),
    ];
    expect(sceneBounds(makeScene({ name: 's', objects }), 2, c)).toEqual({ min: [6, -1, -1], max: [8, 1, 1] });
    expect(sceneBounds(makeScene({ name: 's', objects }), 3.5, c)?.max[1]).toBe(51);
  });

  it('the emission window contains every vertex’s emission time, and is tight for vertices on the line of sight', () => {
    fc.assert(
      fc.property(speed, fc.double({ min: 0, max: 6.28, noNaN: true }), (beta, angle) => {
        const object = cube({
          kind: 'uniform',
          pose: { position: [0, 0, 0], orientation: IDENTITY },
          velocity: [beta * c, 0, 0],
        });
        const observer = { t: 3, position: [20 * Math.cos(angle), 20 * Math.sin(angle), 1] as Vec3 };
        const window = emissionWindow(
          { kind: 'uniform', position: [0, 0, 0], velocity: [beta * c, 0, 0] },
          Math.sqrt(3),
          observer,
          c,
        );
        for (const i of vertices(object)) {
          const t = emissionTime(vertexWorldLine(object, i, c), observer, c)!;
          expect(t).toBeGreaterThanOrEqual(window![0] - 1e-9);
          expect(t).toBeLessThanOrEqual(window![1] + 1e-9);
        }
      }),
    );
    const ahead = emissionWindow({ kind: 'static', position: [8, 0, 0] }, 2, { t: 0, position: [0, 0, 0] }, c);
    expect(ahead![0]).toBeCloseTo(-1, 12);
    expect(ahead![1]).toBeCloseTo(-0.6, 12);
  });
});

describe('cameras', () => {
  it('looks along the given direction with up upwards, also straight up and down', () => {
    const unit = fc
      .tuple(
        fc.double({ min: -1, max: 1, noNaN: true }),
        fc.double({ min: -1, max: 1, noNaN: true }),
        fc.double({ min: -1, max: 1, noNaN: true }),
      )
      .filter((v) => length(v) > 0.1);
    fc.assert(
      fc.property(unit, (forward) => {
        const q = lookAtOrientation(forward, [0, 1, 0]);
        expect(distance(rotate(q, [0, 0, -1]), scale(forward, 1 / length(forward)))).toBeLessThan(1e-9);
        expect(rotate(q, [1, 0, 0])[1]).toBeCloseTo(0, 9);
        expect(rotate(q, [0, 1, 0])[1]).toBeGreaterThanOrEqual(-1e-9);
      }),
    );
    for (const forward of [
      [0, 5, 0],
      [0, -5, 0],
    ] as const)
      expect(distance(rotate(lookAtOrientation(forward, [0, 1, 0]), [0, 0, -1]), scale(forward, 0.2))).toBeLessThan(
        1e-9,
      );
  });

  it('has the velocity of its path, up to and including the last sample', () => {
    const camera: SceneCamera = {
      path: '/C',
      fovY: 1,
      motion: sampled([0, 1, 2], (t) => ({ position: [0, 0, t < 1 ? 0 : 8 * (t - 1)], orientation: IDENTITY })),
    };
    expect(length(observerFromCamera(camera, 0.5, c).u)).toBe(0);
    for (const t of [1, 1.5, 2]) expect(observerFromCamera(camera, t, c).u[2]).toBeCloseTo(0.8 / 0.6, 12);
    expect(length(observerFromCamera(camera, 2.1, c).u)).toBe(0);
    expect(observerFromCamera(camera, 1.5, c)).toMatchObject({ position: [0, 0, 4], lens: { fovY: 1 } });
  });
});
