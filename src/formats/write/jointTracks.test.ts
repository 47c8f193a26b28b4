import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fromParts, type Mat4, multiply } from '../../math/mat4.ts';
import { fromAxisAngle, type Quat, toMatrix } from '../../math/quat.ts';
import { matrixOfParts, partsOf } from '../../math/transformParts.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { distanceOf, keptKeys } from './jointTracks.ts';

const number = fc.double({ min: -3, max: 3, noNaN: true });
const vector = fc.tuple(number, number, number) as fc.Arbitrary<Vec3>;
const rotation = fc
  .tuple(vector, number)
  .map(([axis, angle]): Quat => fromAxisAngle(Math.hypot(...axis) > 1e-3 ? axis : [0, 0, 1], angle));
const sizes = fc.constantFrom(0, 0.2, 1, 3, -1, -0.5);
const scales = fc.tuple(sizes, sizes, sizes) as fc.Arbitrary<Vec3>;
/** T R S, from its definition. */
const placed = (translation: Vec3, turn: Quat, [x, y, z]: Vec3): Mat4 =>
  multiply(fromParts(toMatrix(turn), translation), [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1]);

describe('parts of a matrix', () => {
  it('make it again, mirrored or flattened too', () => {
    fc.assert(
      fc.property(vector, rotation, scales, rotation, (translation, turn, scale, before) => {
        const matrix = placed(translation, turn, scale);
        expect(distanceOf(matrixOfParts(partsOf(matrix, before)), matrix, 1)).toBeLessThan(1e-12);
      }),
    );
  });

  it('of a sheared matrix make another', () => {
    const sheared = [1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    expect(distanceOf(matrixOfParts(partsOf(sheared)), sheared, 1)).toBeGreaterThan(0.1);
  });
});

it('the distance of two matrices bounds that of all places', () => {
  fc.assert(
    fc.property(vector, rotation, scales, vector, rotation, vector, (t, r, s, t2, r2, p) => {
      const [a, b] = [placed(t, r, s), placed(t2, r2, s)];
      const at = (m: Mat4) =>
        [0, 4, 8].map((row) => m[row] * p[0] + m[row + 1] * p[1] + m[row + 2] * p[2] + m[row + 3]);
      const [x, y] = [at(a), at(b)];
      const off = Math.hypot(...x.map((value, i) => value - y[i]));
      expect(off).toBeLessThanOrEqual(distanceOf(a, b, Math.hypot(...p)) + 1e-12);
    }),
  );
});

it('keys are where a polyline bends, and its ends', () => {
  fc.assert(
    fc.property(
      fc.array(fc.integer({ min: 1, max: 40 }), { minLength: 1, maxLength: 8 }),
      fc.infiniteStream(fc.integer({ min: 1, max: 9 })),
      (lengths, slopes) => {
        // Slopes of neighbours differ: each bends.
        const values = [0];
        const bends = [0];
        let slope = 0;
        for (const length of lengths) {
          slope += slopes.next().value as number;
          for (let i = 0; i < length; i++) values.push(values[values.length - 1] + slope);
          bends.push(values.length - 1);
        }
        const isStraight = (from: number, to: number): boolean =>
          values
            .slice(from, to + 1)
            .every((x, i) => Math.abs(x - values[from] - ((values[to] - values[from]) * i) / (to - from)) < 1e-9);
        expect(keptKeys(values.length, isStraight)).toEqual(bends);
      },
    ),
  );
});
