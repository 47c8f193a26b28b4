import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { uniform as between } from '../../../tests/support/physicsArbitraries.ts';
import { makeSystem } from '../system.ts';
import { momentumFactor, velocityChangeFraction } from './energyCorrection.ts';

const C = 2;
const MASSES = [1, 3];
const system = makeSystem({ masses: Float64Array.from(MASSES), c: C });

/** Σ m c²(1/√(1 − v²/c²) − 1) of two points, computed directly [J]. */
const kinetic = (v: readonly number[]): number =>
  MASSES.reduce((sum, m, i) => {
    const square = v[3 * i] ** 2 + v[3 * i + 1] ** 2 + v[3 * i + 2] ** 2;
    return sum + m * C * C * (1 / Math.sqrt(1 - square / (C * C)) - 1);
  }, 0);
const at = (v: readonly number[], dv: readonly number[], share: number): number[] =>
  v.map((value, j) => value + share * dv[j]);
const shareOf = (correction: 1 | 2, v: readonly number[], dv: readonly number[], wanted: number): number =>
  velocityChangeFraction(correction, system, Float64Array.from(v), Float64Array.from(dv), wanted);

/** For both points, slow enough to stay below c. */
const some = fc.array(between(-0.5, 0.5), { minLength: 6, maxLength: 6 });
/** Velocity changes that increase the kinetic energy. */
const faster = fc.tuple(some, some).filter(([v, dv]) => kinetic(at(v, dv, 1)) > kinetic(v) + 1e-3);

describe('the fraction of a step’s velocity change', () => {
  it('by the tangent extrapolates the energy linearly, and reverses where its slope is negative', () => {
    fc.assert(
      fc.property(faster, between(-0.9, 0.9), ([v, dv], part) => {
        const s = 1e-5;
        const slope = (kinetic(at(v, dv, s)) - kinetic(at(v, dv, -s))) / (2 * s);
        fc.pre(Math.abs(slope) > 1e-3);
        expect(shareOf(1, v, dv, part * slope)).toBeCloseTo(part, 5);
        expect(shareOf(1, v, dv, 7 * slope)).toBe(1);
        expect(shareOf(1, v, dv, -7 * slope)).toBe(-1);
      }),
    );
  });

  it('by the secant gives a part of the full gain, and 0 where the potential energy requires less motion', () => {
    fc.assert(
      fc.property(faster, between(0.01, 0.99), ([v, dv], part) => {
        const gain = kinetic(at(v, dv, 1)) - kinetic(v);
        expect(shareOf(2, v, dv, part * gain)).toBeCloseTo(part, 9);
        expect(shareOf(2, v, dv, 3 * gain)).toBe(1);
        expect(shareOf(2, v, dv, -part * gain)).toBe(0);
      }),
    );
  });

  it('by the secant is 1 where it decelerates', () => {
    fc.assert(
      fc.property(some, between(0.05, 0.9), between(-1, 1), (v, part, wanted) => {
        const slower = v.map((value) => -part * value);
        expect(shareOf(2, v, slower, wanted)).toBe(1);
      }),
    );
  });
});

describe('the factor on momenta', () => {
  const momentum = fc.array(between(-3, 3), { minLength: 6, maxLength: 6 });
  const energy = between(-6, 4).map((exponent) => 10 ** exponent);
  /** Σ √(m²c⁴ + p²c²) − mc², computed directly [J]. */
  const kineticOf = (p: ArrayLike<number>): number =>
    MASSES.reduce((sum, m, i) => {
      const rest = m * C * C;
      return sum + Math.hypot(rest, C * p[3 * i], C * p[3 * i + 1], C * p[3 * i + 2]) - rest;
    }, 0);

  it('of one point is that of its energy: p = mc √(γ² − 1), γ = 1 + T/mc²', () => {
    const one = makeSystem({ masses: Float64Array.of(3), c: C });
    fc.assert(
      fc.property(between(0.01, 50), energy, (p, T) => {
        const k = T / (3 * C * C);
        const expected = 3 * C * Math.sqrt(k * (k + 2));
        expect((momentumFactor(one, Float64Array.of(0, p, 0), T, T) * p) / expected).toBeCloseTo(1, 13);
      }),
    );
  });

  it('gives several points the wanted energy to rounding, from Newton’s mechanics to γ in the thousands', () => {
    fc.assert(
      fc.property(momentum, energy, (p, wanted) => {
        fc.pre(Math.hypot(...p) > 0.1);
        const factor = momentumFactor(system, Float64Array.from(p), wanted, wanted);
        // The direct formula cancels the rest energy.
        const off = kineticOf(p.map((value) => factor * value)) - wanted;
        expect(Math.abs(off)).toBeLessThan(1e-13 * (wanted + 4 * C * C));
      }),
    );
    const newton = makeSystem({ masses: Float64Array.of(2) });
    expect(momentumFactor(newton, Float64Array.of(0, 6, 0), 36, 36)).toBeCloseTo(2, 14);
  });

  it('is 0 where all energy is potential, and refused where the potential energy alone is more, or nothing moves', () => {
    const p = Float64Array.of(1, 0, 0, 0, 0, 0);
    expect(momentumFactor(system, p, 0, 1)).toBe(0);
    // A rounding error of a million joules.
    expect(momentumFactor(system, p, -1e-9, 1e6)).toBe(0);
    const refused = (of: Float64Array, wanted: number) => () => momentumFactor(system, of, wanted, 1);
    expect(refused(p, -0.5)).toThrow(/no velocities conserve the energy: the potential energy alone is 0.500 J above/);
    expect(refused(new Float64Array(6), 0.5)).toThrow(/nothing moves that could have 0.500 J/);
    expect(momentumFactor(system, new Float64Array(6), 0, 1)).toBe(1);
  });
});
