import fc from 'fast-check';
import { expect, it } from 'vitest';
import { direction, expectClose, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { determinant, type Mat3 } from '../../math/mat3.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { scale } from '../../math/vec3.ts';
import { objectBoundingSphere } from '../bounds/bounds.ts';
import { objectBounds } from '../bounds/sceneBounds.ts';
import { transformObject } from '../compose/transformScene.ts';
import { makeObject, makeScene, restingAt } from '../defaults.ts';
import { fastestVertex, restToWorld, vertexPositions } from '../motion/motion.ts';
import type { Motion, SceneObject } from '../types.ts';
import { validate } from '../validation/validate.ts';
import { sphere } from './primitives.ts';
import { withoutQuadric } from './quadric.ts';
import { bakedObject } from './stretch.ts';

const C = 10;
const round = sphere(1, { segments: 20, rings: 10 });
const ball = withoutQuadric(round);

const stretches: fc.Arbitrary<Mat3> = fc
  .array(uniform(-2, 2), { minLength: 9, maxLength: 9 })
  .filter((m) => determinant(m) > 0.1);
const turn = fc.tuple(direction, uniform(-3, 3)).map(([axis, angle]) => fromAxisAngle(axis, angle));
const pose = fc.record({ position: fc.tuple(uniform(-5, 5), uniform(-5, 5), uniform(-5, 5)), orientation: turn });
const velocity = fc.tuple(direction, uniform(0, 9)).map(([n, v]) => scale(n, v));
const motions: fc.Arbitrary<Motion> = fc.oneof(
  fc.record({ kind: fc.constant('static' as const), pose }),
  fc.record({ kind: fc.constant('uniform' as const), pose, velocity }),
  fc.record({ kind: fc.constant('hyperbolic' as const), pose, properAcceleration: velocity, t0: uniform(-1, 1) }),
  fc.tuple(pose, pose).map(
    ([a, b]): Motion => ({
      kind: 'sampled',
      times: Float64Array.of(0, 4),
      poses: Float64Array.of(...a.position, ...a.orientation, ...b.position, ...b.orientation),
    }),
  ),
);
const objects = fc
  .record({ stretch: stretches, motion: motions, authoredIn: fc.constantFrom<'world' | 'rest'>('world', 'rest') })
  .map((given) => makeObject({ path: '/It', mesh: ball, ...given }));

const span = (values: ArrayLike<number>): number =>
  Array.from(values).reduce((most, x) => Math.max(most, Math.abs(x)), 1);

it('a stretched object is everywhere what an object with that shape as its mesh is', () => {
  fc.assert(
    fc.property(objects, uniform(-1, 5), (object, t) => {
      const baked: SceneObject = bakedObject(object);
      const [own, other] = [object, baked].map((one) => vertexPositions(one, t, C));
      expectClose([...own], [...other], 1e-6 * span(other));
      const [box, boxOfBaked] = [object, baked].map((one) => objectBounds(one, t, C)!);
      expectClose([...box.min, ...box.max], [...boxOfBaked.min, ...boxOfBaked.max], 1e-5 * span(other));
      const speeds = [object, baked].map((one) => fastestVertex(one, C, [0, 2]).speed);
      expectClose(speeds[0], speeds[1], 1e-5 * (1 + speeds[1]));
      const worlds = [object, baked].map((one) => vertexPositions(restToWorld(one, C), t, C));
      expectClose([...worlds[0]], [...worlds[1]], 2e-5 * span(other));
    }),
  );
});

it('its bounding sphere holds its points, and touches one', () => {
  fc.assert(
    fc.property(stretches, (stretch) => {
      const object = makeObject({ path: '/It', mesh: ball, motion: restingAt([0, 0, 0]), stretch });
      const { center, radius } = objectBoundingSphere(object);
      const points = vertexPositions(object, 0, C);
      let farthest = 0;
      for (let i = 0; i < points.length; i += 3)
        farthest = Math.max(
          farthest,
          Math.hypot(points[i] - center[0], points[i + 1] - center[1], points[i + 2] - center[2]),
        );
      expectClose(radius, farthest, 1e-9 * radius);
    }),
  );
});

it('transforming the object transforms what is seen of it', () => {
  fc.assert(
    fc.property(objects, turn, uniform(0.2, 3), (object, orientation, factor) => {
      fc.pre(object.motion.kind !== 'hyperbolic' && object.authoredIn === 'world');
      const by = { orientation, scale: factor, position: [1, 2, 3] as const };
      const [own, other] = [object, bakedObject(object)].map((one) => vertexPositions(transformObject(one, by), 1, C));
      expectClose([...own], [...other], 1e-5 * span(other));
    }),
  );
});

it.each([
  ['mirrors', [-1, 0, 0, 0, 1, 0, 0, 0, 1]],
  ['flattens', [1, 0, 0, 0, 0, 0, 0, 0, 1]],
  ['is not finite', [1, 0, 0, 0, Number.NaN, 0, 0, 0, 1]],
] as const)('validation finds a stretch that %s', (_, stretch) => {
  const scene = makeScene({ name: 'a', objects: [makeObject({ path: '/It', mesh: ball, stretch })] });
  expect(validate(scene, C)).toMatchObject([{ severity: 'error', code: 'object.stretch', place: '/It' }]);
});

it('validation finds a stretch of a round solid, and none in a proper one', () => {
  const stretch = [2, 0, 0, 0, 1, 0, 0, 0, 1];
  const found = [round, ball].map((mesh) =>
    validate(makeScene({ name: 'a', objects: [makeObject({ path: '/It', mesh, stretch })] }), C).filter(
      ({ code }) => code === 'object.stretch',
    ),
  );
  expect(found.map((each) => each.length)).toEqual([1, 0]);
});
