import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { bigVec, div, dotBig, lengthBig, mul, ONE, sqrt, toNumber } from '../../../tests/support/bigFixed.ts';
import {
  anyProperVelocity,
  direction,
  expectClose,
  offset,
  perpendicular,
  properVelocityUpTo,
  uniform,
  velocityAndOffset,
} from '../../../tests/support/physicsArbitraries.ts';
import { addScaled, cross, dot, length, negate, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { boost, gamma, properVelocity } from '../lorentz/boost.ts';
import { fourVector, spatial } from '../lorentz/fourVector.ts';
import { aberrate, unaberrate } from './aberration.ts';
import { apparentPosition, apparentPositions, inverseApparentPosition } from './apparentPosition.ts';
import { observerDoppler } from './doppler.ts';

/** The formula of docs/physics.md §3.3 as it stands, with 300 digits, where nothing cancels. */
function apparentWithManyDigits(dx: Vec3, u: Vec3): number[] {
  const [x, b] = [bigVec(dx), bigVec(u)];
  const g = sqrt(ONE + dotBig(b, b));
  const factor = div(dotBig(b, x), g + ONE) + lengthBig(x);
  return x.map((xi, i) => toNumber(xi + mul(factor, b[i])));
}

describe('apparent position', () => {
  it('agrees with the exact formula to the last digits, ahead, aside and behind, up to γ = 1000', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, dx]) => {
        const expected = apparentWithManyDigits(dx, u);
        // One rounding of Δx rotates its direction by 1e-16, which the backward cone magnifies by γ.
        expectClose(apparentPosition(dx, u), expected, 2e-15 * gamma(u) * Math.hypot(...expected));
      }),
      { numRuns: 300 },
    ));
  it('is |Δx′| = D|Δx|', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, dx]) => {
        const expected = observerDoppler(dx, u) * length(dx);
        expectClose(length(apparentPosition(dx, u)), expected, 1e-14 * gamma(u) * expected);
      }),
    ));
  it('is the boost of the event on the past light cone', () =>
    fc.assert(
      fc.property(anyProperVelocity, offset, (u, dx) => {
        const expected = spatial(boost(fourVector(-length(dx), dx), u));
        expectClose(apparentPosition(dx, u), expected, 1e-14 * gamma(u) * length(dx));
      }),
    ));
  it('is inverted by its inverse', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, dx]) => {
        expectClose(inverseApparentPosition(apparentPosition(dx, u), u), dx, 1e-14 * gamma(u) ** 2 * length(dx));
      }),
    ));
  it('maps the observer to the origin, and is the identity for an observer at rest', () => {
    expect(apparentPosition([0, 0, 0], [600, 800, 0])).toEqual([0, 0, 0]);
    expect(apparentPosition([1, 2, 3], [0, 0, 0])).toEqual([1, 2, 3]);
    expect(apparentPosition([0, 0, 0], [0, 0, 0])).toEqual([0, 0, 0]);
  });
  it('maps whole arrays, also in place', () =>
    fc.assert(
      fc.property(anyProperVelocity, fc.array(offset, { maxLength: 5 }), (u, points) => {
        const flat = Float64Array.from(points.flat());
        const expected = Float64Array.from(points.flatMap((p) => apparentPosition(p, u)));
        expect(apparentPositions(flat, u)).toEqual(expected);
        expect(apparentPositions(flat, u, flat)).toEqual(expected);
      }),
    ));
});

describe('aberration', () => {
  it('is cos θ′ = (cos θ + β)/(1 + β cos θ)', () =>
    fc.assert(
      fc.property(uniform(0, Math.PI), uniform(0, 0.999), (theta, beta) => {
        const n = aberrate([Math.sin(theta), 0, Math.cos(theta)], properVelocity([0, 0, beta]));
        expectClose(n[2], (Math.cos(theta) + beta) / (1 + beta * Math.cos(theta)), 1e-12);
        expectClose(length(n), 1, 1e-15);
      }),
    ));
  it('maps the hemisphere ahead to the cone of half angle arccos β', () =>
    fc.assert(
      fc.property(anyProperVelocity, uniform(0, 6), (u, phi) => {
        fc.pre(length(u) > 0);
        const across = perpendicular(u, phi);
        expectClose(dot(aberrate(across, u), u), (length(u) * length(u)) / gamma(u), 1e-13 * length(u));
      }),
    ));
  it('is inverted by its inverse', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, dx]) => {
        const n = normalize(dx);
        expectClose(unaberrate(aberrate(n, u), u), n, 1e-15 * gamma(u) ** 2);
        expectClose(aberrate(n, [0, 0, 0]), n, 1e-15);
        // Boosting back restores each colour.
        const there = observerDoppler(n, u);
        const back = observerDoppler(aberrate(n, u), negate(u));
        expectClose(there * back, 1, 1e-14 * gamma(u) ** 2);
      }),
    ));
  it('maps the zero vector to itself', () => expect(aberrate([0, 0, 0], [1, 2, 3])).toEqual([0, 0, 0]));
});

describe("a sphere's outline", () => {
  /** A direction on the circular cone about `axis`. */
  const onCone = (axis: Vec3, halfAngle: number, phi: number): Vec3 =>
    addScaled(scale(axis, Math.cos(halfAngle)), perpendicular(axis, phi), Math.sin(halfAngle));
  it('stays a circle: the tangent directions of a static sphere, aberrated, lie in one plane', () =>
    fc.assert(
      fc.property(direction, uniform(0.05, 1.5), properVelocityUpTo(100), (axis, halfAngle, u) => {
        const seen = [0, 1, 2, 3, 4, 5, 6].map((i) => aberrate(onCone(axis, halfAngle, 0.9 * i), u));
        const [e1, e2] = [sub(seen[2], seen[0]), sub(seen[4], seen[0])];
        const normal = normalize(cross(e1, e2));
        const size = Math.max(...seen.map((n) => length(sub(n, seen[0]))));
        for (const n of seen) expectClose(dot(sub(n, seen[0]), normal), 0, 1e-11 * gamma(u) * size);
      }),
    ));
});
