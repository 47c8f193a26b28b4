import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  anyProperVelocity,
  direction,
  expectClose,
  offset,
  properVelocityUpTo,
  uniform,
} from '../../../tests/support/physicsArbitraries.ts';
import { multiply } from '../../math/mat4.ts';
import { length, negate, scale, type Vec3 } from '../../math/vec3.ts';
import { boost, boostMatrix, gamma, inverseBoost, properVelocity, rapidity, velocity } from './boost.ts';
import { type FourVector, fourVector, interval, minkowskiDot, spatial } from './fourVector.ts';
import {
  applyLorentz,
  applyPoincare,
  composePoincare,
  frameAt,
  invertPoincare,
  POINCARE_IDENTITY,
} from './poincare.ts';

const event = fc.tuple(uniform(-1e5, 1e5), offset).map(([ct, x]): FourVector => fourVector(ct, x));
const size = (X: readonly number[]) => Math.hypot(...X);

describe('velocity measures', () => {
  it('has γ = 5/4 and γβ = 3/4 at β = 3/5', () => {
    expectClose(properVelocity([0.6, 0, 0]), [0.75, 0, 0], 1e-15);
    expectClose(gamma([0.75, 0, 0]), 1.25, 1e-15);
    expectClose(velocity([0, 0.75, 0]), [0, 0.6, 0], 1e-15);
    expectClose(rapidity([0, 0, 0.75]), Math.atanh(0.6), 1e-15);
  });
  it('is exact at rest', () => {
    expect(gamma([0, 0, 0])).toBe(1);
    expect(properVelocity([0, 0, 0])).toEqual([0, 0, 0]);
    expect(velocity([0, 0, 0])).toEqual([0, 0, 0]);
  });
});

describe('boost', () => {
  it("reads the textbook's clock: a light second at β = 3/5", () => {
    expectClose(boost([5, 3, 0, 0], [0.75, 0, 0]), [4, 0, 0, 0], 1e-15);
    expectClose(boost([0, 4, 7, -2], [0.75, 0, 0]), [-3, 5, 7, -2], 1e-14);
  });
  it('is the identity for u = 0', () => fc.assert(fc.property(event, (X) => expectClose(boost(X, [0, 0, 0]), X, 0))));
  it('preserves the interval', () =>
    fc.assert(
      fc.property(anyProperVelocity, event, event, (u, A, B) => {
        const tolerance = 1e-15 * (gamma(u) * (size(A) + size(B))) ** 2;
        expectClose(interval(boost(A, u), boost(B, u)), interval(A, B), 16 * tolerance);
      }),
    ));
  it('is inverted by the inverse boost', () =>
    fc.assert(
      fc.property(anyProperVelocity, event, (u, X) => {
        expectClose(inverseBoost(boost(X, u), u), X, 1e-14 * gamma(u) ** 2 * size(X));
      }),
    ));
  it('adds rapidities along one line', () =>
    fc.assert(
      fc.property(direction, uniform(-3.8, 3.8), uniform(-3.8, 3.8), event, (n, a, b, X) => {
        const twice = boost(boost(X, scale(n, Math.sinh(a))), scale(n, Math.sinh(b)));
        const once = boost(X, scale(n, Math.sinh(a + b)));
        expectClose(twice, once, 1e-14 * Math.exp(Math.abs(a) + Math.abs(b)) * size(X));
      }),
    ));
  it('equals its matrix', () =>
    fc.assert(
      fc.property(anyProperVelocity, event, (u, X) => {
        expectClose(applyLorentz(boostMatrix(u), X), boost(X, u), 1e-14 * gamma(u) * size(X));
      }),
    ));
  it('B(u) B(−u) = 1', () =>
    fc.assert(
      fc.property(properVelocityUpTo(100), (u) => {
        const one = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
        expectClose(multiply(boostMatrix(u), boostMatrix(negate(u))), one, 1e-14 * gamma(u) ** 2);
      }),
    ));
  it('takes an object with proper velocity u to rest', () =>
    fc.assert(
      fc.property(anyProperVelocity, (u) => {
        const U = boost(fourVector(gamma(u), u), u);
        expectClose(spatial(U), [0, 0, 0], 1e-14 * gamma(u) ** 2);
        expectClose(minkowskiDot(fourVector(gamma(u), u), fourVector(gamma(u), u)), -1, 1e-14 * gamma(u) ** 2);
      }),
    ));
});

describe('Poincaré transforms', () => {
  const transform = fc.tuple(event, properVelocityUpTo(20)).map(([origin, u]) => frameAt(origin, u));
  it('takes the event to the origin, and the observer to rest', () => {
    const frame = frameAt([7, 1, 2, 3], [0.75, 0, 0]);
    expectClose(applyPoincare(frame, [7, 1, 2, 3]), [0, 0, 0, 0], 1e-14);
    expectClose(applyPoincare(frame, [12, 4, 2, 3]), [4, 0, 0, 0], 1e-13);
  });
  it('composes like functions, and is inverted by its inverse', () =>
    fc.assert(
      fc.property(transform, transform, event, (p, q, X) => {
        const steps = applyPoincare(p, applyPoincare(q, X));
        expectClose(applyPoincare(composePoincare(p, q), X), steps, 1e-6);
        expectClose(applyPoincare(invertPoincare(p), applyPoincare(p, X)), X, 1e-6);
        expectClose(applyPoincare(POINCARE_IDENTITY, X), X, 0);
      }),
    ));
});

describe('interval', () => {
  it('is 0 along light rays, to the last digit, at any distance', () => {
    const x: Vec3 = [3e12, 4e12, 0];
    expect(interval([0, 0, 0, 0], fourVector(length(x), x))).toBe(0);
  });
});
