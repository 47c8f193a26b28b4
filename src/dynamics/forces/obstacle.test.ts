import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { uniform as between } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, rotate } from '../../math/quat.ts';
import { add, addScaled, length, sub, type Vec3 } from '../../math/vec3.ts';
import { box, plane } from './obstacle.ts';

const place = fc.tuple(between(-3, 3), between(-3, 3), between(-3, 3));
const MIDDLE: Vec3 = [0.3, -0.2, 0.5];
const SIZE: Vec3 = [1, 2, 0.6];
const TURN = fromAxisAngle([1, 2, -1], 0.7);
const OBSTACLES = [
  ['a plane', plane(MIDDLE, [0.2, 1, -0.1])],
  ['a turned box', box(MIDDLE, SIZE, TURN)],
] as const;

describe.each(OBSTACLES)('%s', (_, { distanceAndNormal: outside, distance }) => {
  it('has the same distance with and without the normal, and is 1-Lipschitz', () => {
    fc.assert(
      fc.property(place, place, (a, b) => {
        expect(distance(...a)).toBeCloseTo(outside(a)[0], 12);
        expect(Math.abs(distance(...a) - distance(...b))).toBeLessThanOrEqual(length(sub(a, b)) + 1e-12);
      }),
    );
  });

  it('has its surface at the stated distance', () => {
    fc.assert(
      fc.property(place, (a) => {
        const [far, out] = outside(a);
        expect(distance(...addScaled(a, out, -far))).toBeCloseTo(0, 12);
        expect(length(out)).toBeCloseTo(1, 12);
      }),
    );
  });
});

it('a box is rotated about its centre, with half its size to each side', () => {
  const { distance } = box(MIDDLE, SIZE, TURN);
  for (const [k, way] of (
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const
  ).entries())
    for (const side of [-1, 1]) {
      const at = add(MIDDLE, rotate(TURN, addScaled([0, 0, 0], way, side * (SIZE[k] / 2 + 0.25))));
      expect(distance(...at)).toBeCloseTo(0.25, 12);
    }
});
