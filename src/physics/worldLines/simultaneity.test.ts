import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { bigVec, div, dotBig, mul, ONE, sqrt, toNumber } from '../../../tests/support/bigFixed.ts';
import {
  anyProperVelocity,
  direction,
  expectClose,
  magnitude,
  offset,
  properVelocityUpTo,
  uniform,
} from '../../../tests/support/physicsArbitraries.ts';
import { addScaled, cross, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { boost, gamma, properVelocity, velocity } from '../lorentz/boost.ts';
import { fourVector, spatial } from '../lorentz/fourVector.ts';
import {
  contraction,
  newtonSimultaneousTime,
  simultaneitySlice,
  simultaneousPosition,
  simultaneousPositions,
  simultaneousTime,
  simultaneousTimes,
} from './simultaneity.ts';
import { circularSlice, hyperbolicSlice, uniformSlice } from './slice.ts';
import { positionAt, type WorldLine } from './worldLine.ts';

describe('the slice', () => {
  it('of uniform motion is t = β·x₀/(1 − β·v) to the last digits, also if observer and point move together', () =>
    fc.assert(
      fc.property(
        anyProperVelocity,
        fc.oneof(anyProperVelocity, fc.constant(undefined)),
        magnitude(-6, 0),
        offset,
        (u, other, near, d) => {
          const v = velocity(other ?? addScaled(scale(u, 1 + near), [near, 0, 0], 1));
          const [x, b, w] = [bigVec(d), bigVec(u), bigVec(v)];
          const g = sqrt(ONE + dotBig(b, b));
          const expected = toNumber(div(dotBig(b, x), g - dotBig(b, w)));
          const conditioned = (gamma(u) * length(d)) / toNumber(g - dotBig(b, w));
          expectClose(
            uniformSlice(d, 0, v, u).ahead,
            expected,
            1e-14 * (conditioned + Math.abs(expected) * gamma(u) ** 2),
          );
        },
      ),
      { numRuns: 300 },
    ));
  it('of hyperbolic motion solves its equation with 300 digits', () =>
    fc.assert(
      fc.property(anyProperVelocity, offset, direction, magnitude(-9, 2), uniform(-1e4, 1e4), (u, d, n, k, T) => {
        const a = scale(n, k);
        const { ahead, offset: dx } = hyperbolicSlice(d, T, a, u);
        // On the hyperbola: (along + ℓ)² − (T + ahead)² = ℓ², along from the turning point.
        const [A, out] = [bigVec(a), bigVec(sub(dx, d))];
        const kk = sqrt(dotBig(A, A));
        const along = div(dotBig(out, A), kk);
        const s = bigVec([T + ahead])[0];
        const off = toNumber(mul(along, along) * 1n + div(2n * along, kk) - mul(s, s));
        const size = length(d) + Math.abs(T) + Math.abs(ahead) + length(dx);
        expectClose(off / (1 / k + size) / size, 0, 1e-13);
        // And simultaneous: ct = β·Δx.
        expectClose(ahead * gamma(u) - dot(u, dx), 0, 1e-13 * gamma(u) * size * (1 + k * (length(d) + Math.abs(T))));
      }),
      { numRuns: 300 },
    ));
  it('of a circle is simultaneous, and on the circle', () =>
    fc.assert(
      fc.property(
        anyProperVelocity,
        offset,
        direction,
        magnitude(-2, 2),
        uniform(0, 0.999),
        (u, center, axis, r, beta) => {
          const arm = scale(normalize(cross(axis, [0.36, 0.48, 0.8]), [1, 0, 0]), r);
          const { ahead, offset: dx } = circularSlice(center, axis, arm, beta / r, u);
          expectClose(ahead - dot(velocity(u), dx), 0, 1e-13 * (length(center) + r));
          expectClose(length(sub(dx, center)), r, 1e-13 * (length(center) + r));
        },
      ),
    ));

  const lines = (n: Vec3, at: Vec3): WorldLine[] => [
    { kind: 'static', position: at },
    { kind: 'uniform', position: at, velocity: scale(n, 7) },
    { kind: 'hyperbolic', position: at, properAcceleration: scale(n, 2), t0: 1 },
    {
      kind: 'circular',
      center: at,
      axis: n,
      arm: normalize(cross(n, [0.36, 0.48, 0.8]), [1, 0, 0]),
      angularVelocity: 8,
    },
    {
      kind: 'polyline',
      times: Float64Array.of(-5, 0, 5),
      positions: Float64Array.from([...at, ...addScaled(at, n, 40), ...addScaled(at, n, -3)]),
    },
  ];
  it('has Δt′ = 0 under the boost, for every kind of world line', () =>
    fc.assert(
      fc.property(direction, offset, properVelocityUpTo(50), offset, uniform(-9, 9), (n, at, u, position, t) => {
        const all = lines(n, at);
        for (const w of all) {
          const e = simultaneousTime(w, { t, position }, u, 10);
          const dx = sub(positionAt(w, e, 10), position);
          const [ct, ...x] = boost(fourVector(10 * (e - t), dx), u);
          const size = length(dx) + length(position) + length(at) + 10 * Math.abs(e);
          expectClose(ct, 0, 1e-12 * gamma(u) * size);
          expectClose(simultaneousPosition(dx, u), [x[0], x[1], x[2]], 1e-12 * gamma(u) * size);
          expectClose(simultaneitySlice(w, { t, position }, u, 10).offset, dx, 1e-12 * gamma(u) * size);
        }
        const each = all.map((w) => simultaneousTime(w, { t, position }, u, 10));
        expect([...simultaneousTimes(all, { t, position }, u, 10)]).toEqual(each);
      }),
    ));
  it('of an observer at rest is the same moment', () => {
    for (const w of lines([0, 0, 1], [3, 4, 5]))
      expectClose(simultaneousTime(w, { t: 2, position: [0, 0, 0] }, [0, 0, 0], 10), 2, 1e-14);
  });
  it('of an observer on the world line is the observer’s event', () => {
    for (const w of lines([0, 0.6, 0.8], [3, 4, 5]))
      expectClose(simultaneousTime(w, { t: 2, position: positionAt(w, 2, 10) }, [30, 40, 0], 10), 2, 1e-12);
  });
  it('of a polyline is at rest outside its samples', () => {
    const w: WorldLine = {
      kind: 'polyline',
      times: Float64Array.of(0, 1),
      positions: Float64Array.of(100, 0, 0, 105, 0, 0),
    };
    // β = 0.6: the point 100 m ahead is 6 s ahead.
    expectClose(simultaneousTime(w, { t: -9, position: [0, 0, 0] }, [0.75, 0, 0], 10), -3, 1e-14);
    expectClose(simultaneousTime(w, { t: 3, position: [0, 0, 0] }, [0.75, 0, 0], 10), 9.3, 1e-14);
  });
});

describe('contraction', () => {
  it('of a rod at rest in the world is L/γ for the moving observer', () => {
    const u = properVelocity([0.6, 0, 0]);
    expectClose(simultaneousPosition([10, 0, 0], u), [8, 0, 0], 1e-14);
    expectClose(simultaneousPosition([0, 10, 0], u), [0, 10, 0], 0);
  });
  it('of a moving rod is L/γ in the world: both ends on their world lines at one time', () =>
    fc.assert(
      fc.property(properVelocityUpTo(50), offset, (u, rod) => {
        const world = contraction(rod, u);
        // The ends at one world time lie, in the rest frame, at the rest offset (whenever that is).
        expectClose(spatial(boost(fourVector(0, world), u)), rod, 1e-13 * gamma(u) * length(rod));
        const ahead = normalize(u);
        expectClose(dot(world, ahead), dot(rod, ahead) / gamma(u), 1e-15 * length(rod) * 8);
      }),
    ));
  it('of a moving rod for a co-moving observer is its rest length', () =>
    fc.assert(
      fc.property(properVelocityUpTo(20), offset, (u, rod) => {
        const [c, v] = [10, scale(velocity(u), 10)];
        const end: WorldLine = { kind: 'uniform', position: contraction(rod, u), velocity: v };
        const { offset: dx } = simultaneitySlice(end, { t: 0, position: [0, 0, 0] }, u, c);
        expectClose(simultaneousPosition(dx, u), rod, 1e-12 * gamma(u) ** 2 * length(rod));
      }),
    ));
  it('maps whole arrays, also in place', () =>
    fc.assert(
      fc.property(anyProperVelocity, fc.array(offset, { maxLength: 5 }), (u, points) => {
        const flat = Float64Array.from(points.flat());
        const expected = Float64Array.from(points.flatMap((p) => simultaneousPosition(p, u)));
        expect(simultaneousPositions(flat, u)).toEqual(expected);
        expect(simultaneousPositions(flat, u, flat)).toEqual(expected);
      }),
    ));
});

describe('Newton’s iteration in the slice', () => {
  it('leaves (1 − k)ⁿ of c Δt = β·d/(1 − β·v), where the motion is uniform', () =>
    fc.assert(
      fc.property(
        properVelocityUpTo(3),
        properVelocityUpTo(3),
        offset,
        fc.constantFrom(0.1, 0.5, 1),
        fc.nat(10),
        (u, other, d, damping, iterations) => {
          const [beta, v] = [velocity(u), velocity(other)];
          const w: WorldLine = { kind: 'uniform', position: addScaled(d, v, -70), velocity: scale(v, 10) };
          const exact = dot(beta, d) / (10 * (1 - dot(beta, v)));
          const found = newtonSimultaneousTime(w, { t: 7, position: [0, 0, 0] }, u, 10, { iterations, damping });
          expectClose(found - 7, exact * (1 - (1 - damping) ** iterations), 1e-10 * (length(d) + 70));
        },
      ),
    ));
  it('converges to the slice on a curve', () => {
    const w: WorldLine = {
      kind: 'circular',
      center: [40, 0, 0],
      axis: [0, 0, 1],
      arm: [5, 0, 0],
      angularVelocity: 0.5,
    };
    const observer = { t: 3, position: [0, 0, 0] as Vec3 };
    const u: Vec3 = [0.75, 0.2, 0];
    const found = newtonSimultaneousTime(w, observer, u, 10, { iterations: 8, damping: 1 });
    expect(found).toBeCloseTo(simultaneousTime(w, observer, u, 10), 10);
    expect(Math.abs(found - 3)).toBeGreaterThan(1);
  });
});
