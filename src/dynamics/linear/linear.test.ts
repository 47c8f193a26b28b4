import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { random } from '../../math/random.ts';
import type { Stiffness } from '../forces/force.ts';
import { springForce } from '../forces/springs.ts';
import { AndersonAcceleration } from './andersonAcceleration.ts';
import { ConjugateGradients } from './conjugateGradients.ts';
import { StepMatrix } from './stepMatrix.ts';

const N = 6;

/** Springs between all points, stretched or compressed. */
function net(seed: number, form: 'exact' | 'safe' | 'isotropic', size: number): Stiffness {
  const next = random(seed);
  const ends = Array.from({ length: N * N }, (_, k) => [Math.floor(k / N), k % N]).filter(([i, j]) => i < j);
  const force = springForce({
    ends: Uint32Array.from(ends.flat()),
    stiffness: Float64Array.from(ends, () => 5 * next()),
    lengths: Float64Array.from(ends, () => next()),
  });
  return force.stiffness(
    Float64Array.from({ length: 3 * N }, () => size * next()),
    form,
  );
}

function matrix(seed: number, form: 'exact' | 'safe' | 'isotropic', size = 2): StepMatrix {
  const next = random(seed + 1);
  const weights = Float64Array.from({ length: N }, () => 0.5 + next());
  const u = Float64Array.from({ length: 3 * N }, () => 2 * next() - 1);
  const A = new StepMatrix(Uint8Array.of(0, 1, 0, 0, 0, 0));
  A.set([net(seed, form, size)], weights, u);
  return A;
}

const column = (A: StepMatrix, j: number): Float64Array => {
  const [unit, out] = [new Float64Array(3 * N), new Float64Array(3 * N)];
  unit[j] = 1;
  A.multiply(unit, out);
  return out;
};

describe('the matrix of a step', () => {
  it('is symmetric over moving points, at any velocities', () => {
    fc.assert(
      fc.property(fc.integer(), (seed) => {
        const columns = Array.from({ length: 3 * N }, (_, j) => column(matrix(seed, 'exact'), j));
        for (let i = 0; i < 3 * N; i++)
          for (let j = 0; j < 3 * N; j++)
            if (Math.floor(i / 3) !== 1 && Math.floor(j / 3) !== 1)
              expect(columns[j][i]).toBeCloseTo(columns[i][j], 12);
      }),
      { numRuns: 20 },
    );
  });
});

describe('conjugate gradients', () => {
  it('solve the system, and do not move pinned points', () => {
    fc.assert(
      fc.property(fc.integer(), fc.constantFrom('safe', 'isotropic'), (seed, form) => {
        const A = matrix(seed, form);
        const next = random(seed + 2);
        const wanted = Float64Array.from({ length: 3 * N }, (_, j) => (Math.floor(j / 3) === 1 ? 0 : next() - 0.5));
        const b = new Float64Array(3 * N);
        A.multiply(wanted, b);
        const x = new Float64Array(3 * N);
        const { converged, iterations } = new ConjugateGradients(3 * N).solve(A, b, x, 1e-12, 200);
        expect(converged).toBe(true);
        expect(iterations).toBeLessThan(3 * N + 5);
        x.forEach((value, j) => {
          expect(value).toBeCloseTo(wanted[j], 9);
        });
      }),
    );
  });

  it('report a matrix that is not positive definite, as for compressed springs', () => {
    const A = matrix(3, 'exact', 0.1);
    const b = new Float64Array(3 * N).fill(1);
    b.fill(0, 3, 6);
    const { indefinite, converged } = new ConjugateGradients(3 * N).solve(A, b, new Float64Array(3 * N), 1e-12, 200);
    expect([indefinite, converged]).toEqual([true, false]);
  });
});

describe('Anderson mixing', () => {
  it('finds the fixed point of a one-dimensional linear iteration in three rounds, also of a divergent one', () => {
    const x = Float64Array.of(1, 2, 3);
    const mixing = new AndersonAcceleration(3);
    const end = [5, -1, 2];
    for (let round = 0; round < 3; round++)
      mixing.next(
        x,
        x.map((value, k) => -2.4 * (value - end[k])),
      );
    x.forEach((value, k) => {
      expect(value).toBeCloseTo(end[k], 12);
    });
  });

  it('converges faster than the plain iteration, whose errors decay at different rates', () => {
    // x → Bx converges to 0.
    const B = [-0.25, -0.1, 0, -0.2];
    const mixing = new AndersonAcceleration(4);
    const x = Float64Array.of(1, 1, 1, 1);
    for (let round = 0; round < 12; round++)
      mixing.next(
        x,
        x.map((value, k) => B[k] * value - value),
      );
    expect(Math.hypot(...x)).toBeLessThan(1e-3 * 0.25 ** 12);
  });
});
