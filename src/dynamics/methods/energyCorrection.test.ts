import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { uniform as between } from '../../../tests/support/physicsArbitraries.ts';
import { makeSystem } from '../system.ts';
import { velocityChangeFraction } from './energyCorrection.ts';

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
const shareOf = (correction: 0 | 1 | 2 | 3, v: readonly number[], dv: readonly number[], wanted: number): number =>
  velocityChangeFraction(correction, system, Float64Array.from(v), Float64Array.from(dv), wanted);

/** For both points, slow enough to stay below c. */
const some = fc.array(between(-0.5, 0.5), { minLength: 6, maxLength: 6 });
/** Velocity changes that increase the kinetic energy. */
const faster = fc.tuple(some, some).filter(([v, dv]) => kinetic(at(v, dv, 1)) > kinetic(v) + 1e-3);

describe('the fraction of a step’s velocity change', () => {
  it('is 1 without a correction', () => {
    expect(shareOf(0, [1, 0, 0, 0, 0, 0], [0.5, 0, 0, 0, 0, 0], 1e-6)).toBe(1);
  });

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

  it('is 1 where it decelerates, by the secant and by the root', () => {
    fc.assert(
      fc.property(some, between(0.05, 0.9), between(-1, 1), (v, part, wanted) => {
        const slower = v.map((value) => -part * value);
        for (const correction of [2, 3] as const) expect(shareOf(correction, v, slower, wanted)).toBe(1);
      }),
    );
  });

  it('by the root gives exactly the required energy, if that lies between tangent and secant', () => {
    let found = 0;
    fc.assert(
      fc.property(faster, between(0.01, 0.99), ([v, dv], part) => {
        const wanted = part * (kinetic(at(v, dv, 1)) - kinetic(v));
        const [tangent, secant, root] = ([1, 2, 3] as const).map((correction) => shareOf(correction, v, dv, wanted));
        const [low, high] = [Math.min(Math.max(0, tangent), secant), Math.max(tangent, secant)];
        expect(root).toBeGreaterThanOrEqual(low);
        expect(root).toBeLessThanOrEqual(high);
        const gained = (share: number): number => kinetic(at(v, dv, share)) - kinetic(v) - wanted;
        if (gained(low) * gained(high) >= 0) return;
        found++;
        expect(Math.abs(gained(root))).toBeLessThan(1e-9);
        expect(Math.abs(root - secant)).toBeGreaterThan(0);
      }),
    );
    expect(found).toBeGreaterThan(20);
  });
});
