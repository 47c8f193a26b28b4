import fc from 'fast-check';
import { expect, it } from 'vitest';
import { direction, expectClose, uniform } from '../../../../tests/support/physicsArbitraries.ts';
import { probePoint, viewFrom } from '../../../../tests/support/rays.ts';
import { distance, length, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { cubicAt } from '../../../physics/worldLines/cubicPiece.ts';
import type { HypersurfaceName } from '../../../physics/worldLines/hypersurface.ts';
import { makeObject, makeScene } from '../../../scene/defaults.ts';
import { grid } from '../../../scene/mesh/primitives.ts';
import { type CubicPointsMotion, parabolaVelocities, pointPiece } from '../../../scene/motion/cubicPoints.ts';
import type { View } from '../../../scene/views/views.ts';
import { makeBatches } from '../../geometry/batches.ts';
import { makeBody } from '../../geometry/bodies.ts';
import { Clusters } from '../plan/clusters.ts';
import { DeformingClusterBounds } from '../plan/deformingClusterBounds.ts';
import { CubicPointsIntersector } from './cubicPointsIntersector.ts';

const C = 10;
/** Of the view from slice to cone, by default. */
const CONE_SLOPE = 0.5;
const mesh = grid(3, 3, 2, 2);
const HYPERSURFACES: readonly (readonly [View, HypersurfaceName])[] = [
  ['light-cone', 'past-light-cone'],
  ['simultaneity', 'slice'],
  ['slice-to-cone', 'shallow-cone'],
  ['galilean', 'now'],
];

const motionOf = (seed: number, size: number): CubicPointsMotion => {
  const times = Float64Array.from({ length: 16 }, (_, k) => -2 + k / 5);
  const points = Array.from(times, (t) =>
    mesh.positions.map((x, i) => x + size * Math.sin(6 * t + seed + 1.3 * mesh.positions[i - (i % 3)] + i)),
  );
  return { kind: 'sampled-points', times, origin: [0, 0, -4], points, velocities: parabolaVelocities(times, points) };
};
const whole = { first: 0, count: 16 };

it('points between vertices are found where the formulas for single points place them', () => {
  const corner = fc.integer({ min: 0, max: mesh.indices.length / 3 - 1 }).map((k) => 3 * k);
  const observers = fc.record({ t: uniform(-3, 3), turn: direction, far: uniform(0, 6), rapidity: uniform(0, 3) });
  fc.assert(
    fc.property(corner, uniform(0, 0.5), uniform(0, 0.5), observers, uniform(0, 9), (at, v, w, observer, seed) => {
      // Waves of 0.8 m would be faster than light here, so their bend is reduced.
      for (const size of [0.3, 0.8]) {
        const motion = motionOf(seed, size);
        const object = makeObject({ path: '/It', mesh, motion });
        const view = viewFrom({
          t: observer.t,
          position: scale(observer.turn, observer.far),
          u: scale(observer.turn, Math.sinh(observer.rapidity)),
        });
        const u: Vec3 = view.u;
        for (const [name, surface] of HYPERSURFACES) {
          const intersector = new CubicPointsIntersector(motion, whole, {
            t: view.t,
            position: view.position,
            u,
            c: C,
            hypersurface: surface,
            coneSlope: CONE_SLOPE,
          });
          intersector.setTriangle(
            ...([0, 1, 2].map((k) => mesh.indices[at + k]) as unknown as [number, number, number]),
          );
          const out = new Float64Array(3);
          intersector.intersect(v, w, out, 0);
          const expected = size < 0.5 ? probePoint(object, { corner: at, v, w }, view, C, name) : undefined;
          if (expected)
            expectClose(
              [...out],
              sub(expected.position, view.position),
              1e-9 * (20 + observer.far) * Math.cosh(observer.rapidity) ** 2,
            );
          expect([...out].every(Number.isFinite)).toBe(true);
        }
      }
    }),
    { numRuns: 200 },
  );
});

/** All samples are equal: everything moves between them. */
function hopping(): CubicPointsMotion {
  const motion = motionOf(1, 0.4);
  const points = motion.points.map(() => motion.points[0]);
  const velocities = points.map((p, k) => p.map((_, i) => (i % 3 === k % 3 ? 6 * (-1) ** k : 0)));
  return { ...motion, points, velocities };
}

it.each([
  ['waves', motionOf(1, 0.4)],
  ['hops', hopping()],
])(
  'a cluster of %s bounds its triangles at all times, and the speeds and accelerations of their points',
  (_, motion) => {
    const object = makeObject({ path: '/It', mesh, motion });
    const body = makeBody(object, 1);
    const [batch] = makeBatches(makeScene({ name: 'it', objects: [object] }), [body]);
    const clusters = new Clusters(batch);
    const clusterBounds = new DeformingClusterBounds(clusters, batch.arrays.indices, motion).boundsOver({
      first: 3,
      count: 5,
    });
    const { line } = body;
    let nearest = Number.POSITIVE_INFINITY;
    for (const { x, y, z, radius, maxSpeed, maxAcceleration = 0 } of clusterBounds)
      for (let k = 3; k < 7; k++)
        for (let i = 0; 3 * i < mesh.positions.length; i++)
          for (const w of [0.1, 0.3, 0.5, 0.8]) {
            const piece = pointPiece(motion, k, i);
            const [here, after] = [w, w + 1e-5].map((fraction) => cubicAt(piece, fraction * piece.span));
            expect(distance(here.x, [x, y, z])).toBeLessThanOrEqual(radius * (1 + 1e-6));
            expect(length(here.v)).toBeLessThanOrEqual(maxSpeed);
            expect(distance(here.v, after.v) / (1e-5 * piece.span)).toBeLessThanOrEqual(maxAcceleration * (1 + 1e-4));
            nearest = Math.min(nearest, maxSpeed - length(here.v));
            if (line.kind !== 'polyline') continue;
            const center = [0, 1, 2].map(
              (n) => line.positions[3 * k + n] * (1 - w) + line.positions[3 * k + 3 + n] * w,
            );
            const place = here.x.map((n, axis) => n + motion.origin[axis] - center[axis]);
            expect(Math.hypot(...place)).toBeLessThanOrEqual(body.radius * (1 + 1e-6));
          }
    expect(nearest).toBeLessThan(5);
  },
);

it('curves are smooth except where the motion begins and ends, or its bend is reduced', () => {
  const observation = {
    t: 0,
    position: [0, 0, 0] as Vec3,
    u: [0, 0, 0] as Vec3,
    hypersurface: 'now' as const,
    coneSlope: 1,
  };
  const smooth = (window: { first: number; count: number }, c: number) =>
    new CubicPointsIntersector(motionOf(1, 0.4), window, { ...observation, c }).smooth;
  expect(smooth({ first: 3, count: 5 }, C)).toBe(true);
  expect(smooth({ first: 0, count: 5 }, C)).toBe(false);
  expect(smooth({ first: 3, count: 13 }, C)).toBe(false);
  expect(smooth({ first: 3, count: 5 }, 2.5)).toBe(false);
});
