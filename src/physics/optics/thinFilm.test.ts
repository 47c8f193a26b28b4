import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { uniform } from '../../../tests/support/physicsArbitraries.ts';
import { thinFilmReflectance } from './thinFilm.ts';

/** By the characteristic matrix of the film (Abelès 1950), of one polarisation: M = [[cos δ, i sin δ/η], [i η sin δ, cos δ]], r = (η₀B − C)/(η₀B + C). */
function byMatrix([e0, e1, e2]: readonly number[], delta: number): number {
  const [c, s] = [Math.cos(delta), Math.sin(delta)];
  // B = cos δ + i (η₂/η₁) sin δ, C = η₂ cos δ + i η₁ sin δ.
  const [b, bi, q, qi] = [c, (e2 / e1) * s, e2 * c, e1 * s];
  return ((e0 * b - q) ** 2 + (e0 * bi - qi) ** 2) / ((e0 * b + q) ** 2 + (e0 * bi + qi) ** 2);
}

describe('a thin film', () => {
  it('reflects as its characteristic matrix says', () => {
    fc.assert(
      fc.property(
        uniform(0.05, 1),
        uniform(1, 2.5),
        uniform(1, 5),
        uniform(0, 2000),
        uniform(300, 900),
        (cos, n, m, d, l) => {
          const sin = Math.sqrt(1 - cos * cos);
          const [c1, c2, c3] = [cos, Math.sqrt(1 - (sin / n) ** 2), Math.sqrt(1 - (sin / m) ** 2)];
          const delta = (2 * Math.PI * n * d * c2) / l;
          const s = byMatrix([c1, n * c2, m * c3], delta);
          const p = byMatrix([1 / c1, n / c2, m / c3], delta);
          const R = thinFilmReflectance(cos, n, m, d, l);
          expect(R).toBeCloseTo((s + p) / 2, 9);
          expect(R).toBeLessThanOrEqual(1);
        },
      ),
    );
  });

  it('of a quarter wave is an antireflection coating where n² = n₃', () => {
    expect(thinFilmReflectance(1, 1.5, 2.25, 100, 600)).toBeCloseTo(0, 12);
    expect(thinFilmReflectance(1, 1.5, 2.25, 200, 600)).toBeCloseTo((1.25 / 3.25) ** 2, 12);
  });
});
