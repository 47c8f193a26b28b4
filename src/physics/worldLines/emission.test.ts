import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  type Big,
  big,
  bigVec,
  div,
  dotBig,
  lengthBig,
  mul,
  ONE,
  sqrt,
  toNumber,
} from '../../../tests/support/bigFixed.ts';
import {
  anyProperVelocity,
  direction,
  expectClose,
  magnitude,
  offset,
  uniform,
  velocityAndOffset,
} from '../../../tests/support/physicsArbitraries.ts';
import { addScaled, cross, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { gamma, velocity } from '../lorentz/boost.ts';
import {
  circularEmission,
  hyperbolicEmission,
  polylineEmission,
  presentEmission,
  staticEmission,
  uniformEmission,
} from './emission.ts';

/** 1 − v², rounded once. */
const oneMinus = (v: Vec3) => toNumber(ONE - dotBig(bigVec(v), bigVec(v)));

/** The textbook quadratic with 300 digits: delay of a point in uniform motion that is at d at the observer's time. */
function delayWithManyDigits(d: Vec3, v: Vec3): number {
  const [x, b] = [bigVec(d), bigVec(v)];
  const dv = dotBig(x, b);
  const a = ONE - dotBig(b, b);
  return toNumber(div(sqrt(mul(dv, dv) + mul(a, dotBig(x, x))) - dv, a));
}

describe('uniform emission', () => {
  it('is the retarded root to the last digits, approaching, receding and passing, up to γ = 1000', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, d]) => {
        const v = velocity(u);
        const expected = delayWithManyDigits(d, v);
        const seen = presentEmission(d, v, oneMinus(v));
        expectClose(seen.delay / expected, 1, 4e-15 * gamma(u));
        expectClose(length(seen.offset), seen.delay, 1e-14 * (length(d) + seen.delay));
      }),
      { numRuns: 300 },
    ));
  it('does not depend on the anchor point of the body', () =>
    fc.assert(
      fc.property(anyProperVelocity, offset, direction, magnitude(-3, 3), (u, d, n, reach) => {
        const v = velocity(u);
        const o = scale(n, reach);
        const a = oneMinus(v);
        const expected = presentEmission([d[0] + o[0], d[1] + o[1], d[2] + o[2]], v, a);
        const center = presentEmission(d, v, a);
        // One rounding of the centre's position rotates its direction, which the backward cone magnifies by γ².
        const size = reach + length(d) + center.delay + expected.delay;
        const tolerance = 2e-15 * size * gamma(u) ** 2;
        expectClose(uniformEmission(center.offset, v, a, o).offset, expected.offset, tolerance);
      }),
    ));
  it('is accurate for a near point of a large body', () => {
    // The centre is 1 km away, the point a micrometre from it; both pass at walking pace and at 0.9 c.
    for (const beta of [1e-8, 0.9]) {
      const [v, d]: Vec3[] = [
        [beta, 0, 0],
        [0, 0, 1000],
      ];
      const o: Vec3 = [0, 1e-6, -1000];
      const center = presentEmission(d, v, oneMinus(v)).offset;
      expectClose(uniformEmission(center, v, oneMinus(v), o).delay, delayWithManyDigits([0, 1e-6, 0], v), 1e-12);
    }
  });
  it('is the observer’s event for an observer on the world line', () => {
    expect(presentEmission([0, 0, 0], [0.6, 0, 0], 0.64)).toEqual({ offset: [0, 0, 0], delay: 0 });
    expect(presentEmission([0, 0, 0], [0, 0, 0], 1)).toEqual({ offset: [0, 0, 0], delay: 0 });
    expect(staticEmission([0, 3, 4])).toEqual({ offset: [0, 3, 4], delay: 5 });
  });
});

describe('polyline piece', () => {
  it('that contains the root gives the same as unlimited uniform motion', () =>
    fc.assert(
      fc.property(velocityAndOffset, magnitude(-3, 3), magnitude(-3, 3), ([u, d], before, after) => {
        const v = velocity(u);
        const exact = presentEmission(d, v, oneMinus(v));
        const [tA, tB] = [-exact.delay - before, -exact.delay + after];
        const seen = polylineEmission(addScaled(d, v, tA), tA, addScaled(d, v, tB), tB);
        // The velocity, and with it 1 − v², has the rounding errors of the two samples; the event is on the light cone nevertheless.
        const size = length(d) + Math.abs(tA) + Math.abs(tB);
        const there = addScaled(d, v, -seen.delay);
        expectClose(seen.offset, there, 1e-14 * size * (1 + size / (tB - tA)));
        if (gamma(u) < 10) expectClose(seen.offset, exact.offset, 1e-11 * size * (1 + size / (tB - tA)));
      }),
      { numRuns: 300 },
    ));
  it('is found at its ends', () => {
    expect(polylineEmission([3, 4, 0], -5, [3, 4, 1], -3).offset).toEqual([3, 4, 0]);
    expectClose(polylineEmission([3, 4, 0.5], -7, [3, 4, 0], -5).offset, [3, 4, 0], 1e-14);
    // With the observer at the sample.
    expect(polylineEmission([0, 0, 0], 0, [0.5, 0, 0], 1)).toEqual({ offset: [0, 0, 0], delay: 0 });
    expectClose(polylineEmission([0.5, 0, 0], -1, [0, 0, 0], 0).delay, 0, 1e-16);
  });
});

/** The quadratic of docs/physics.md §4.4 in w = e^{aτ} with 300 digits: the delay, or undefined behind the horizon. */
function hyperbolicWithManyDigits(d: Vec3, T: number, a: Vec3): number | undefined {
  const [x, acceleration, time] = [bigVec(d), bigVec(a), big(T)];
  const k = lengthBig(acceleration);
  const l = div(ONE, k);
  const along = -div(dotBig(x, acceleration), k);
  const X = along + l;
  const Y2 = dotBig(x, x) - mul(along, along);
  const [ahead, behind]: Big[] = [X + time, X - time];
  if (ahead <= 0n) return undefined;
  const B = mul(k, mul(X, X) + Y2 - mul(time, time) + mul(l, l));
  const w = div(2n * ahead, B + sqrt(mul(B, B) - 4n * mul(ahead, behind)));
  return toNumber(time - mul(l, w - div(ONE, w)) / 2n);
}

describe('hyperbolic emission', () => {
  const acceleration = fc.tuple(direction, magnitude(-9, 2)).map(([n, k]) => scale(n, k));
  const since = fc.tuple(fc.constantFrom(-1, 0, 1), magnitude(-4, 4)).map(([s, t]) => s * t);

  it('is the retarded root of the quadratic with 300 digits, and undefined behind the horizon', () => {
    let visible = 0;
    fc.assert(
      fc.property(offset, since, acceleration, (d, T, a) => {
        const reach = length(a) * (length(d) + Math.abs(T));
        // Exactly at the horizon the last digit decides.
        fc.pre(Math.abs(1 - dot(a, d) + length(a) * T) > 1e-15 * (1 + reach));
        const expected = hyperbolicWithManyDigits(d, T, a);
        const seen = hyperbolicEmission(d, T, a);
        expect(seen === undefined).toBe(expected === undefined);
        if (!seen || expected === undefined) return;
        visible++;
        // The delay diverges at the horizon, 1 + k(T + ξ) → 0, which limits the accuracy.
        const margin = 1 - dot(a, d) + length(a) * T;
        const blur = 1 + (length(a) * (length(d) + Math.abs(T))) / margin;
        expectClose(
          seen.delay,
          expected,
          1e-14 * (length(d) + Math.abs(T) + expected) * (blur + length(a) * Math.abs(T)),
        );
        expect(seen.delay).toBeGreaterThanOrEqual(0);
      }),
      { numRuns: 500 },
    );
    expect(visible).toBeGreaterThan(100);
  });
  it('agrees with a direct search along the rapidity', () =>
    fc.assert(
      fc.property(direction, magnitude(-1, 1), direction, magnitude(-1, 1), uniform(-3, 3), (n, r, m, k, T) => {
        const [d, a] = [scale(n, r), scale(m, k)];
        const late = (eta: number) => length(addScaled(d, m, (Math.cosh(eta) - 1) / k)) - T + Math.sinh(eta) / k;
        fc.pre(1 - dot(a, d) + k * T > 1e-2);
        let [lo, hi] = [-30, 30];
        for (let i = 0; i < 200; i++) {
          const mid = (lo + hi) / 2;
          if (late(mid) < 0) lo = mid;
          else hi = mid;
        }
        expectClose(
          hyperbolicEmission(d, T, a)?.delay ?? Number.NaN,
          T - Math.sinh(lo) / k,
          1e-9 * (1 + Math.cosh(lo) / k),
        );
      }),
    ));
  it('approaches that of a point at rest for a → 0, to the last digit', () => {
    const d: Vec3 = [1, 2, 2];
    expect(hyperbolicEmission(d, 50, [0, 0, 0])).toEqual({ offset: d, delay: 3 });
    expectClose(hyperbolicEmission(d, 50, [1e-30, 0, 0])?.delay ?? 0, 3, 1e-14);
    expectClose(hyperbolicEmission(d, 0, [0, 0, 1e-30])?.offset ?? [], d, 1e-15);
  });
  it('is the observer’s event for an observer on the world line', () => {
    expect(hyperbolicEmission([0, 0, 0], 0, [1, 0, 0])).toEqual({ offset: [0, 0, 0], delay: 0 });
    const eta = 2;
    const there = hyperbolicEmission([1 - Math.cosh(eta), 0, 0], Math.sinh(eta), [1, 0, 0]);
    expectClose(there?.delay ?? Number.NaN, 0, 1e-14);
  });
  it('is behind the horizon from exactly X + T = 0 on', () => {
    // a = 1: the centre is 1 behind the turning point; an observer at rest there sees nothing until it turns.
    const turning: Vec3 = [1, 0, 0];
    expect(hyperbolicEmission(turning, 0, [1, 0, 0])).toBeUndefined();
    expect(hyperbolicEmission(turning, -1, [1, 0, 0])).toBeUndefined();
    expect(hyperbolicEmission(turning, 1e-6, [1, 0, 0])?.delay).toBeGreaterThan(1e5);
  });
});

describe('circular emission', () => {
  it('lies on the past light cone, up to γ = 1000 at the rim', () =>
    fc.assert(
      fc.property(anyProperVelocity, offset, direction, magnitude(-2, 2), (u, center, any, radius) => {
        const axis = normalize(cross(any, [0.36, 0.48, 0.8]), [0, 0, 1]);
        const arm = scale(normalize(cross(axis, Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0])), radius);
        const seen = circularEmission(center, axis, arm, length(velocity(u)) / radius);
        expectClose(length(seen.offset), seen.delay, 2e-14 * (length(center) + radius));
        expectClose(length(sub(seen.offset, center)), radius, 1e-14 * (length(center) + radius));
        expect(seen.delay).toBeGreaterThanOrEqual(0);
      }),
    ));
  it('seen from the axis lags by the angle ω r', () => {
    const seen = circularEmission([0, 0, 4], [0, 0, 1], [3, 0, 0], 0.25);
    expectClose(seen.delay, 5, 1e-14);
    expectClose(seen.offset, [3 * Math.cos(1.25), -3 * Math.sin(1.25), 4], 1e-14);
  });
  it('is the observer’s event for an observer on the circle, and the centre sees the whole circle at one time', () => {
    expectClose(circularEmission([-1, 0, 0], [0, 0, 1], [1, 0, 0], 0.9).delay, 0, 1e-15);
    expectClose(circularEmission([0, 0, 0], [0, 0, 1], [2, 0, 0], 0.4).delay, 2, 1e-15);
    expectClose(circularEmission([5, 0, 0], [0, 0, 1], [0, 0, 0], 0.4).delay, 5, 1e-15);
  });
});
