import fc from 'fast-check';
import { expect, it } from 'vitest';
import { fromAxisAngle } from '../../math/quat.ts';
import { makeObject } from '../defaults.ts';
import { sphere } from '../mesh/primitives.ts';
import { vertexPositions } from '../motion/motion.ts';
import type { Motion } from '../types.ts';
import { boundingBox } from './bounds.ts';
import { objectBounds } from './sceneBounds.ts';

it('the box of an object is that of its vertices, at any orientation and motion', () => {
  const mesh = sphere(1, { segments: 20 });
  const deformed = { ...mesh, positions: mesh.positions.map((x, i) => x * (1 + 0.3 * Math.sin(i))) };
  const angle = fc.double({ min: -3, max: 3, noNaN: true });
  fc.assert(
    fc.property(angle, angle, angle, fc.constantFrom('world' as const, 'rest' as const), (a, b, t, authoredIn) => {
      const pose = { position: [a, b, 1] as const, orientation: fromAxisAngle([a, 1, b], b) };
      const poses = Float64Array.of(a, b, 0, 0, 0, 0, 1, 2, 1, b, ...fromAxisAngle([1, a, b], a));
      const motions: Motion[] = [
        { kind: 'static', pose },
        { kind: 'uniform', pose, velocity: [16, 2, 0] },
        { kind: 'sampled', times: Float64Array.of(-1, 2), poses },
      ];
      for (const motion of motions) {
        const object = { ...makeObject({ path: '/a', mesh: deformed, motion }), authoredIn };
        const expected = boundingBox(vertexPositions(object, t, 20));
        const found = objectBounds(object, t, 20);
        for (const side of ['min', 'max'] as const)
          for (let k = 0; k < 3; k++) expect(found?.[side][k]).toBeCloseTo(expected?.[side][k] ?? Number.NaN, 9);
      }
    }),
    { numRuns: 50 },
  );
});
