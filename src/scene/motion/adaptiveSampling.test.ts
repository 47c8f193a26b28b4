import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AdaptivePath, type ChordCriterion, type SampledTimes, SamplingBudget } from './adaptiveSampling.ts';

type Shape = (time: number) => ArrayLike<number>;

const refineTimes = (samples: number[], shape: Shape, how: ChordCriterion & { readonly most: number }): SampledTimes =>
  new AdaptivePath(Float64Array.from(samples), shape, how).sample(how.most);

const HOW = {
  tolerance: 1e-3,
  fractions: [0.118, 0.283, 0.5, 0.691, 0.877],
  maxHalvings: 14,
  most: Number.POSITIVE_INFINITY,
};
const RADIUS = 2;
const turning =
  (turns: number) =>
  (t: number): number[] => [RADIUS * Math.cos(2 * Math.PI * turns * t), RADIUS * Math.sin(2 * Math.PI * turns * t), 0];

describe('times between samples', () => {
  it('are added until chords are within the tolerance of a circle', () => {
    const { times, error, needed } = refineTimes([0, 1], turning(1), HOW);
    expect(error).toBeLessThanOrEqual(1e-3);
    // A chord over the angle a leaves a circle of radius r by r(1 − cos a/2); the number of pieces is a power of two.
    const pieces = 2 ** Math.ceil(Math.log2(Math.PI / Math.acos(1 - 1e-3 / RADIUS)));
    expect(times).toEqual(Float64Array.from({ length: pieces + 1 }, (_, i) => i / pieces));
    expect(needed).toBe(pieces + 1);
  });

  it('are added where whole turns look like rest at both ends and in the middle', () => {
    for (const turns of [1, 2, 3, 4, 5, 10, 16]) {
      const { times } = refineTimes([0, 1], turning(turns), { ...HOW, tolerance: 1e-2 });
      expect(times.length, `${turns}`).toBeGreaterThan(20 * turns);
    }
  });

  it('are not added to straight uniform motion, nor on a ramp', () => {
    const sliding = (t: number): number[] => [t, 2 * t, 0];
    expect(refineTimes([0, 1, 3], sliding, { ...HOW, tolerance: 1e-9 }).times).toEqual(Float64Array.of(0, 1, 3));
    expect(refineTimes([0, 1], turning(1), { ...HOW, ramps: new Set([1]) }).times).toEqual(Float64Array.of(0, 1));
  });

  it('report the remaining error where a jump cannot be followed', () => {
    const { times, error } = refineTimes([0, 1], (t) => [t < 0.4 ? 0 : 5, 0, 0], HOW);
    expect(error).toBeGreaterThan(1);
    expect(times.length).toBeLessThan(50);
  });

  it('are not added where a path is not finite', () => {
    expect(refineTimes([0, 1], (t) => [t === 0 ? 0 : Number.NaN, 0, 0], HOW).times).toHaveLength(2);
    expect(refineTimes([0, 1], (t) => [t > 0.2 ? 1e200 : 0, 0, 0], HOW).times).toHaveLength(2);
  });

  it('end at their limit, spread over the whole motion', () => {
    const { times, error, needed: wanted } = refineTimes([0, 1], turning(1), { ...HOW, most: 15 });
    expect(times).toEqual(Float64Array.from({ length: 17 }, (_, i) => i / 16));
    // Sixteen chords of a circle: r(1 − cos π/16), seen at the middle of each.
    expect(error).toBeCloseTo(RADIUS * (1 - Math.cos(Math.PI / 16)), 12);
    // The closed form for the tolerance is π / arccos(1 − tolerance / r) pieces.
    const needed = Math.PI / Math.acos(1 - 1e-3 / RADIUS);
    expect(wanted).toBeGreaterThan(needed * 0.9);
    expect(wanted).toBeLessThan(needed * 1.5);
  });
});

describe('a path evaluated at many times', () => {
  const times = fc
    .uniqueArray(fc.integer({ min: 0, max: 40 }), { minLength: 2, maxLength: 8 })
    .map((list) => list.sort((a, b) => a - b));
  const bounds = fc.array(fc.oneof(fc.nat(40), fc.constant(Number.POSITIVE_INFINITY)), { minLength: 1, maxLength: 6 });
  const wild =
    (speed: number, jump: number): Shape =>
    (t) => [Math.cos(speed * t * t), t < jump ? 0 : Math.sin(speed * t), t / 7];

  it('gives the same as single evaluations', () => {
    fc.assert(
      fc.property(
        times,
        bounds,
        fc.double({ min: 0, max: 3, noNaN: true }),
        fc.nat(40),
        (samples, most, speed, jump) => {
          const how = { tolerance: 0.01, fractions: [0.3, 0.5], maxHalvings: 5 };
          const shared = new AdaptivePath(Float64Array.from(samples), wild(speed, jump), how);
          for (const bound of most)
            expect(shared.sample(bound)).toEqual(refineTimes(samples, wild(speed, jump), { ...how, most: bound }));
        },
      ),
    );
  });

  it('is evaluated once', () => {
    let looks = 0;
    const counted: Shape = (t) => {
      looks++;
      return turning(1)(t);
    };
    const path = new AdaptivePath(Float64Array.of(0, 1), counted, HOW);
    const found = path.sample(HOW.most);
    const once = looks;
    expect(path.sample(1e6)).toBe(found);
    expect(path.sample(10).times).toHaveLength(12);
    expect(looks).toBe(once);
  });
});

describe('a budget', () => {
  const added = (budget: SamplingBudget, cost: number): number =>
    budget.sample(new AdaptivePath(Float64Array.of(0, 1), turning(1000.7), HOW), cost).times.length - 2;

  it('gives each motion half of the remainder, by cost', () => {
    // Ten evaluations per added time.
    const budget = new SamplingBudget(16_000);
    expect([1, 1, 2, 1].map((cost) => added(budget, cost))).toEqual([800, 400, 100, 100]);
  });

  it('does not limit motions that need little', () => {
    const free = refineTimes([0, 1], turning(1), HOW).times;
    expect(new SamplingBudget(1e6).sample(new AdaptivePath(Float64Array.of(0, 1), turning(1), HOW), 1).times).toEqual(
      free,
    );
  });
});
