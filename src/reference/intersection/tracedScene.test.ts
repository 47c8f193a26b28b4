import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  anyProperVelocity,
  direction,
  expectClose,
  properVelocityUpTo,
  uniform,
} from '../../../tests/support/physicsArbitraries.ts';
import { probePoint, settingsFor, tracedScene, viewFrom } from '../../../tests/support/rays.ts';
import { fromAxisAngle, multiply } from '../../math/quat.ts';
import { add, distance, length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import { makeObject, makeScene } from '../../scene/defaults.ts';
import { box, sphere } from '../../scene/mesh/primitives.ts';
import { withoutQuadric } from '../../scene/mesh/quadric.ts';
import type { Mesh, Motion, SceneObject } from '../../scene/types.ts';
import type { View } from '../../scene/views/views.ts';
import { dopplerOfHit } from '../aov.ts';
import { cameraRay } from '../camera/cameraRay.ts';
import { rayToward } from '../camera/lensRay.ts';
import { fromPreparedScene, nearestHit, prepareScene } from './tracedScene.ts';

const C = 10;
const rotation = fc.tuple(direction, uniform(-3, 3)).map(([axis, angle]) => fromAxisAngle(axis, angle));
const place = fc.tuple(direction, uniform(0, 30)).map(([n, r]) => scale(n, r));
const pose = fc.record({ position: place, orientation: rotation });
const views = fc.constantFrom<View>('light-cone', 'simultaneity', 'galilean');

const closed: fc.Arbitrary<Motion> = fc.oneof(
  fc.record({ kind: fc.constant('static' as const), pose }),
  fc.record({
    kind: fc.constant('uniform' as const),
    pose,
    velocity: properVelocityUpTo(30).map((u) => scale(velocity(u), C)),
  }),
  fc.record({
    kind: fc.constant('hyperbolic' as const),
    pose,
    properAcceleration: fc.tuple(direction, uniform(0, 30)).map(([n, a]) => scale(n, a)),
    t0: uniform(-3, 3),
  }),
);

/** A body of about a metre that moves and turns, slowly enough for each of its points to stay below c. */
const wandering: fc.Arbitrary<Motion> = fc
  .tuple(place, rotation, fc.array(fc.tuple(direction, uniform(0, 4), direction), { minLength: 1, maxLength: 8 }))
  .map(([start, turn, steps]) => {
    const poses = [...start, ...turn];
    const times = [-4];
    let [position, orientation] = [start, turn];
    for (const [toward, far, axis] of steps) {
      position = add(position, scale(toward, far));
      orientation = multiply(fromAxisAngle(axis, far / 3), orientation);
      poses.push(...position, ...orientation);
      times.push(times[times.length - 1] + 0.6);
    }
    return { kind: 'sampled', times: Float64Array.from(times), poses: Float64Array.from(poses) };
  });

/** Every vertex has a world line of its own. */
const deforming = (mesh: Mesh): fc.Arbitrary<Motion> =>
  fc.tuple(place, fc.integer(), fc.integer({ min: 2, max: 6 })).map(([origin, seed, count]) => {
    const shift = (k: number, i: number) => 0.3 * Math.sin(seed + 7.3 * k + 1.7 * i);
    const points = Array.from({ length: count }, (_, k) => mesh.positions.map((x, i) => x + shift(k, i)));
    return { kind: 'sampled-points', times: Float64Array.from(points, (_, k) => k - 4), origin, points };
  });

const ball = sphere(1, { segments: 10, rings: 6 });
const block = box([1, 2, 0.5]);

/** No horizon is within the body: its size times the acceleration stays below c². */
const object: fc.Arbitrary<SceneObject> = fc.constantFrom(ball, block).chain((mesh) =>
  fc
    .record({
      motion: fc.oneof({ weight: 3, arbitrary: closed }, wandering, deforming(mesh)),
      authoredIn: fc.constantFrom<'world' | 'rest'>('world', 'rest'),
      stretch: fc.constantFrom(undefined, [0.5, 0.2, 0, 0, 1.2, 0.3, 0, 0, 0.8]),
    })
    .map(({ motion, authoredIn, stretch }) => {
      const sampled = motion.kind === 'sampled' || motion.kind === 'sampled-points';
      const maps = motion.kind === 'static' || motion.kind === 'uniform';
      const shape = stretch && maps ? { mesh: withoutQuadric(mesh), stretch } : { mesh };
      return makeObject({ path: '/It', ...shape, motion, authoredIn: sampled ? 'world' : authoredIn });
    }),
);

const observer = fc
  .record({ t: uniform(-2, 5), position: place, u: properVelocityUpTo(50) })
  .map((given) => viewFrom(given));

/** A surface point of an object: a triangle, and weights well inside it. */
const somewhere = (of: SceneObject) =>
  fc
    .tuple(fc.integer({ min: 0, max: of.mesh.indices.length / 3 - 1 }), uniform(0.05, 0.9), uniform(0.05, 0.9))
    .map(([triangle, v, w]) => ({ corner: 3 * triangle, v: v * (1 - w), w }));

describe('ray intersection', () => {
  it('hits a surface point where and when it is seen', () =>
    fc.assert(
      fc.property(
        object.chain((o) => fc.tuple(fc.constant(o), somewhere(o))),
        observer,
        views,
        ([o, point], view, how) => {
          const seen = probePoint(o, point, view, C, how);
          fc.pre(seen !== undefined && seen.distance > 1e-3 && seen.distance < 1e4);
          if (!seen) return;
          const ray = rayToward(view, settingsFor(how, C), normalize(seen.apparent));
          const near = 1e-7 * (1 + seen.distance);
          const hit = nearestHit(tracedScene([o], C), ray, {
            accepts: ({ corner, s }) => corner === point.corner && Math.abs(s - seen.distance) < near,
          });
          if (!hit) return expect.fail(`missed ${o.motion.kind} (${o.authoredIn}) in ${how} at ${seen.distance}`);
          expectClose([hit.v, hit.w], [point.v, point.w], 1e-5);
          expectClose(hit.time, seen.time, (1e-8 / C) * (1 + seen.distance));
          expectClose(hit.position, seen.position, 1e-8 * (1 + length(view.position) + seen.distance));
          expectClose(hit.velocity, seen.velocity, 1e-5);
          if (how === 'light-cone') expectClose(dopplerOfHit(hit, ray, view.u), seen.doppler, 1e-4 * seen.doppler);
          expect(nearestHit(tracedScene([o], C), ray)?.s, 'nothing seen is missed').toBeLessThan(seen.distance + near);
        },
      ),
      { numRuns: 400 },
    ));

  it('every hit is seen there', () =>
    fc.assert(
      fc.property(
        fc.array(object, { minLength: 1, maxLength: 4 }),
        observer,
        views,
        place,
        (objects, view, how, aim) => {
          fc.pre(length(aim) > 0);
          const n = normalize(aim);
          const hit = nearestHit(tracedScene(objects, C), rayToward(view, settingsFor(how, C), n));
          if (!hit) return;
          const seen = probePoint(objects[hit.object], hit, view, C, how);
          expect(distance(seen?.apparent ?? [0, 0, 0], scale(n, hit.s))).toBeLessThan(1e-6 * (1 + hit.s));
          expectClose(length(hit.normal), 1, 1e-12);
        },
      ),
      { numRuns: 300 },
    ));

  it('the hit of a scene is that of its nearest object', () =>
    fc.assert(
      fc.property(
        fc.array(object, { minLength: 2, maxLength: 9 }),
        observer,
        views,
        direction,
        (objects, view, how, n) => {
          const ray = rayToward(view, settingsFor(how, C), n);
          const alone = objects.map((o) => nearestHit(tracedScene([o], C), ray)?.s ?? Number.POSITIVE_INFINITY);
          const all = nearestHit(tracedScene(objects, C), ray);
          expect(all?.s ?? Number.POSITIVE_INFINITY).toBe(Math.min(...alone));
          if (all) expect(alone[all.object]).toBe(all.s);
        },
      ),
      { numRuns: 80 },
    ));

  it('does not depend on the shape cache', () =>
    fc.assert(
      fc.property(
        fc.array(object, { minLength: 3, maxLength: 5 }),
        observer,
        fc.array(direction),
        (objects, view, ways) => {
          const ground = prepareScene(makeScene({ name: 'test', objects }), C);
          const [ample, poor] = [fromPreparedScene(ground), fromPreparedScene(ground, 1)];
          for (const n of ways) {
            const ray = rayToward(view, settingsFor('light-cone', C), n);
            expect(nearestHit(poor, ray)).toEqual(nearestHit(ample, ray));
          }
        },
      ),
      { numRuns: 60 },
    ));

  it('the hit of an object is that of its nearest triangle', () =>
    fc.assert(
      fc.property(object, observer, views, uniform(-1, 1), uniform(-1, 1), (o, view, how, x, y) => {
        const center = probePoint(o, { corner: 0, v: 0.3, w: 0.3 }, view, C, how);
        fc.pre(center !== undefined && center.distance > 0);
        const n = normalize(add(normalize(center?.apparent ?? [0, 0, 1]), [0.1 * x, 0.1 * y, 0.05 * (x - y)]));
        const ray = rayToward(view, settingsFor(how, C), n);
        const { mesh } = o;
        let nearest = Number.POSITIVE_INFINITY;
        for (let k = 0; k < mesh.indices.length; k += 3) {
          const one = { ...o, mesh: { ...mesh, indices: mesh.indices.slice(k, k + 3) } };
          nearest = Math.min(nearest, nearestHit(tracedScene([one], C), ray)?.s ?? nearest);
        }
        const all = nearestHit(tracedScene([o], C), ray)?.s ?? Number.POSITIVE_INFINITY;
        if (all !== nearest) expectClose(all, nearest, 1e-9 * (1 + nearest));
      }),
      { numRuns: 60 },
    ));
});

describe('lifetimes and filters', () => {
  const wall = (z: number, lifetime = { birth: Number.NEGATIVE_INFINITY, death: Number.POSITIVE_INFINITY }) =>
    makeObject({
      path: `/Wall${z}`,
      mesh: box([4, 4, 1]),
      lifetime,
      motion: { kind: 'static', pose: { position: [0, 0, z], orientation: [0, 0, 0, 1] } },
    });
  const ray = rayToward(viewFrom(), settingsFor('light-cone'), [0, 0, -1]);

  it('only surfaces that exist at the emission event are hit', () => {
    const at = (birth: number, death: number) =>
      nearestHit(tracedScene([wall(-5, { birth, death }), wall(-9)]), ray)?.s;
    expect(at(-5, 0)).toBe(4.5);
    // Between the two the front side is gone but the back side still exists.
    expect(at(-6, -5)).toBe(5.5);
    expect(at(-4, 0)).toBe(8.5);
    expect(at(-9, -6)).toBe(8.5);
  });

  it('hits count between `begin` and `end`, if accepted', () => {
    const scene = tracedScene([wall(-5), wall(-9)]);
    expect(nearestHit(scene, ray, { begin: 4.6 })).toMatchObject({ s: 5.5, front: false, object: 0 });
    expect(nearestHit(scene, ray, { begin: 6, end: 8 })).toBeUndefined();
    expect(nearestHit(scene, ray, { begin: 4.6, visibleSides: true })).toMatchObject({ s: 8.5, object: 1 });
    expect(nearestHit(scene, ray, { accepts: ({ object: o }) => o === 1 })).toMatchObject({ s: 8.5, front: true });
    expect(nearestHit(scene, ray, { accepts: () => false, alwaysAccept: [false, true] })).toMatchObject({ object: 1 });
  });
});

describe('camera rays', () => {
  const view = fc.record({ u: anyProperVelocity, n: direction });

  it('contain the events seen in their direction, s being the distance in the observer’s frame, at any γ', () =>
    fc.assert(
      fc.property(view, uniform(0, 100), ({ u, n }, s) => {
        const ray = rayToward(viewFrom({ u }), settingsFor('light-cone'), n);
        expectClose(-ray.dt, length(ray.dx), 1e-15 * length(ray.dx));
        const away: Vec3 = scale(ray.dx, s);
        const g = Math.hypot(1, ...u);
        const along = (u[0] * away[0] + u[1] * away[1] + u[2] * away[2]) / (g + 1) + length(away);
        expectClose(
          away.map((x, i) => x + along * u[i]),
          scale(n, s),
          4e-16 * g * g * length(away) + 1e-13 * s,
        );
      }),
    ));

  it('pass through the pixels of a picture', () => {
    const center = cameraRay(viewFrom(), settingsFor('galilean'), 160, 90, 320, 180)!;
    expectClose(center.dx, [0, 0, -1], 1e-15);
    const corner = cameraRay(viewFrom(), settingsFor('galilean'), 0, 0, 320, 180)!;
    expectClose(corner.dx, normalize([-16 / 9, 1, -1]), 1e-15);
  });

  it('follow the settings of view, light delay and aberration', () => {
    const fast = viewFrom({ u: [0, 3, 0] });
    const settings = settingsFor('light-cone');
    expect(rayToward(fast, { ...settings, lightDelay: false }, [0, 0, 1]).dt).toBe(0);
    expect(rayToward(fast, { ...settings, aberration: false }, [0, 0, 1])).toMatchObject({ dt: -1, dx: [0, 0, 1] });
    expect(rayToward(fast, { ...settings, view: 'galilean' }, [0, 0, 1])).toMatchObject({ dt: 0, dx: [0, 0, 1] });
    expect(rayToward(fast, { ...settings, view: 'simultaneity' }, [0, 1, 0]).dt).toBeCloseTo(3, 14);
  });
});
