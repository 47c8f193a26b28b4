import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromParts, invert, transformPoint } from '../../math/mat4.ts';
import { conjugate, fromAxisAngle, rotate } from '../../math/quat.ts';
import { add, sub, type Vec3 } from '../../math/vec3.ts';
import { makeObject } from '../../scene/defaults.ts';
import { transformMesh } from '../../scene/mesh/meshOps.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { capsule, cone, cylinder, sphere } from '../../scene/mesh/primitives.ts';
import { batchSolidOf, TrianglePoints } from './batchSolids.ts';

const CENTER: Vec3 = [0.3, -0.2, 0.5];
/** Signed distances, or what has their sign, in the solid's own axes. */
const SHAPES = {
  sphere: { mesh: sphere(2), outside: ([x, y, z]: Vec3) => Math.hypot(x, y, z) - 2 },
  cylinder: {
    mesh: cylinder(1.5, 3),
    outside: ([x, y, z]: Vec3) => Math.max(Math.hypot(x, y) - 1.5, Math.abs(z) - 1.5),
  },
  cone: {
    mesh: cone(1, 2),
    outside: ([x, y, z]: Vec3) => Math.max(Math.hypot(x, y) - (1 - z) / 2, -1 - z),
  },
  capsule: {
    mesh: capsule(1, 2),
    outside: ([x, y, z]: Vec3) => Math.hypot(x, y, Math.max(0, Math.abs(z) - 1)) - 1,
  },
};

describe.each(Object.entries(SHAPES))('points of triangles of a %s', (_, { mesh: own, outside }) => {
  it('are on its surface, whatever its stretch and turn, and its corners stay in place', () =>
    fc.assert(
      fc.property(
        direction,
        fc.tuple(uniform(0.3, 2), uniform(-2, -0.3), uniform(-0.5, 0.5)),
        fc.nat(own.indices.length / 3 - 1),
        fc.tuple(uniform(0, 1), uniform(0, 1)),
        (axis, [a, b, shear], triangle, [p, q]) => {
          const mesh = transformMesh(own, fromParts([a, shear, 0, 0, b, 0, shear, 0, 1], [1, 2, 3]));
          const turn = fromAxisAngle(axis, 2);
          const solid = batchSolidOf(makeObject({ path: '/Solid', mesh }), CENTER, turn);
          const positions = new Float32Array(mesh.positions.length);
          for (let v = 0; v < positions.length / 3; v++)
            positions.set(rotate(turn, sub(pointAt(mesh.positions, v), CENTER)), 3 * v);
          const points = new TrianglePoints(positions, solid);
          const corners = [...mesh.indices.subarray(3 * triangle, 3 * triangle + 3)] as [number, number, number];
          points.select(...corners);
          points.set(0, 1);
          expect([points.x, points.y, points.z]).toEqual(pointAt(positions, corners[2]));
          const [w1, w2] = p + q > 1 ? [1 - p, 1 - q] : [p, q];
          points.set(w1, w2);
          const back = add(rotate(conjugate(turn), [points.x, points.y, points.z]), CENTER);
          const there = transformPoint(invert(mesh.quadric!.toMesh)!, back);
          // Positions are f32.
          expect(Math.abs(outside(there))).toBeLessThan(3e-6);
        },
      ),
    ));
});

it('what is no round solid has none', () => {
  expect(batchSolidOf(makeObject({ path: '/Prism', mesh: cylinder(1, 1, { segments: 6 }) }), CENTER, undefined)).toBe(
    undefined,
  );
});
