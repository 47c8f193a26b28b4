import fc from 'fast-check';
import { expect, it } from 'vitest';
import { direction, expectClose, properVelocityUpTo, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { probePoint, settingsFor, tracedScene, viewFrom } from '../../../tests/support/rays.ts';
import { determinant, type Mat3 } from '../../math/mat3.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { dot, normalize, scale } from '../../math/vec3.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import { makeObject } from '../../scene/defaults.ts';
import { sphere } from '../../scene/mesh/primitives.ts';
import { withoutQuadric } from '../../scene/mesh/quadric.ts';
import { bakedObject } from '../../scene/mesh/stretch.ts';
import type { Motion } from '../../scene/types.ts';
import type { View } from '../../scene/views/views.ts';
import { rayToward } from '../camera/lensRay.ts';
import { surfaceAt } from '../materials/surface.ts';
import { reflectionOrigin } from '../transport/rayOrigin.ts';
import { nearestHit } from './tracedScene.ts';

const C = 10;
const ball = withoutQuadric(sphere(1, { segments: 12, rings: 8 }));

const stretches: fc.Arbitrary<Mat3> = fc
  .array(uniform(-2, 2), { minLength: 9, maxLength: 9 })
  .filter((m) => determinant(m) > 0.3);

const pose = fc.record({
  position: fc.tuple(direction, uniform(3, 20)).map(([n, r]) => scale(n, r)),
  orientation: fc.tuple(direction, uniform(-3, 3)).map(([axis, angle]) => fromAxisAngle(axis, angle)),
});

const motions: fc.Arbitrary<Motion> = fc.oneof(
  fc.record({ kind: fc.constant('static' as const), pose }),
  fc.record({
    kind: fc.constant('uniform' as const),
    pose,
    velocity: properVelocityUpTo(10).map((u) => scale(velocity(u), C)),
  }),
  fc.record({
    kind: fc.constant('hyperbolic' as const),
    pose,
    properAcceleration: fc.tuple(direction, uniform(0, 5)).map(([n, a]) => scale(n, a)),
    t0: uniform(-3, 3),
  }),
  fc.tuple(pose, pose).map(
    ([a, b]): Motion => ({
      kind: 'sampled',
      times: Float64Array.of(-30, 30),
      poses: Float64Array.of(...a.position, ...a.orientation, ...b.position, ...b.orientation),
    }),
  ),
);

it('a stretched body is hit where a body with that shape as its mesh is, with the same normals', () => {
  let hits = 0;
  fc.assert(
    fc.property(
      stretches,
      motions,
      fc.constantFrom<'world' | 'rest'>('world', 'rest'),
      fc.constantFrom<View>('light-cone', 'simultaneity'),
      fc.integer({ min: 0, max: ball.indices.length / 3 - 1 }),
      (stretch, motion, frame, view, triangle) => {
        const authoredIn = motion.kind === 'sampled' ? 'world' : frame;
        const object = makeObject({ path: '/It', mesh: ball, motion, authoredIn, stretch });
        const scenes = [object, bakedObject(object)].map((one) => tracedScene([one], C));
        const seen = probePoint(object, { corner: 3 * triangle, v: 0.3, w: 0.3 }, viewFrom(), C, view);
        fc.pre(seen !== undefined && seen.distance > 0.1);
        const ray = rayToward(viewFrom(), settingsFor(view, C), normalize(seen.apparent));
        const [own, baked] = scenes.map((scene) => nearestHit(scene, ray));
        expect(own === undefined).toBe(baked === undefined);
        if (!own || !baked) return;
        hits++;
        expect(own.corner).toBe(baked.corner);
        expect(own.front).toBe(baked.front);
        expectClose(own.s, baked.s, 1e-5 * (1 + baked.s));
        expect(dot(own.normal, baked.normal)).toBeGreaterThan(1 - 1e-5);
        const normals = [surfaceAt(scenes[0], own), surfaceAt(scenes[1], baked)].map(({ normal }) => normal);
        expect(dot(normals[0], normals[1])).toBeGreaterThan(1 - 1e-5);
        const origins = [reflectionOrigin(scenes[0], own), reflectionOrigin(scenes[1], baked)];
        origins[0].x.forEach((x, k) => void expectClose(x, origins[1].x[k], 1e-4));
      },
    ),
    { numRuns: 300 },
  );
  expect(hits).toBeGreaterThan(100);
});

it('bodies with stretches of their own share the tree of their mesh', () => {
  const objects = [1, 2, 3].map((size) =>
    makeObject({ path: `/${size}`, mesh: ball, stretch: [size, 0, 0, 0, 1, 0, 0, 0, 1] }),
  );
  expect(new Set(tracedScene(objects, C).objects.map(({ mesh }) => mesh)).size).toBe(1);
});
