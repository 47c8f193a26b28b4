import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  anyProperVelocity,
  direction,
  expectClose,
  properVelocityUpTo,
  uniform,
} from '../../../tests/support/physicsArbitraries.ts';
import { multiply } from '../../math/mat4.ts';
import { fromAxisAngle, rotate, rotationAngle, toMatrix } from '../../math/quat.ts';
import { cross, dot, length, negate, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { boostMatrix, gamma, properVelocity, rapidity, velocity } from './boost.ts';
import { addVelocities, fourAcceleration, relativeVelocity, wignerRotation } from './velocity.ts';

describe('velocity addition', () => {
  it('gives 0.8 c for ±0.5 c head-on', () => {
    const [right, left] = [properVelocity([0.5, 0, 0]), properVelocity([-0.5, 0, 0])];
    expectClose(velocity(relativeVelocity(right, left)), [0.8, 0, 0], 1e-15);
    expectClose(velocity(relativeVelocity(left, right)), [-0.8, 0, 0], 1e-15);
  });
  it('agrees with the component formula for perpendicular velocities', () => {
    // Taylor & Wheeler: w∥ = v, w⊥ = w′⊥/γ for a transverse w′.
    const sum = velocity(addVelocities(properVelocity([0.6, 0, 0]), properVelocity([0, 0.5, 0])));
    expectClose(sum, [0.6, 0.4, 0], 1e-15);
  });
  it('adds rapidities along one line', () =>
    fc.assert(
      fc.property(direction, uniform(0, 3.8), uniform(0, 3.8), (n, a, b) => {
        const sum = addVelocities(scale(n, Math.sinh(a)), scale(n, Math.sinh(b)));
        expectClose(rapidity(sum), a + b, 1e-14 * (1 + a + b));
      }),
    ));
  it('of a velocity relative to itself is 0, at any speed', () =>
    fc.assert(
      fc.property(anyProperVelocity, (u) => {
        expectClose(relativeVelocity(u, u), [0, 0, 0], 1e-15 * length(u) ** 2);
        expectClose(addVelocities(u, [0, 0, 0]), u, 0);
        expectClose(addVelocities([0, 0, 0], u), u, 0);
      }),
    ));
  it('finds the same relative speed from both sides: γ = γ₁γ₂ − u₁·u₂', () =>
    fc.assert(
      fc.property(anyProperVelocity, anyProperVelocity, (u1, u2) => {
        const expected = gamma(u1) * gamma(u2) - dot(u1, u2);
        const tolerance = 1e-14 * gamma(u1) * gamma(u2);
        expectClose(gamma(relativeVelocity(u1, u2)), expected, tolerance);
        expectClose(gamma(relativeVelocity(u2, u1)), expected, tolerance);
      }),
    ));
  it('never reaches c', () =>
    fc.assert(fc.property(anyProperVelocity, anyProperVelocity, (a, b) => length(velocity(addVelocities(a, b))) <= 1)));
});

describe('Wigner rotation', () => {
  const lorentz = (r: readonly number[]) => [1, 0, 0, 0, 0, ...r.slice(0, 3), 0, ...r.slice(3, 6), 0, ...r.slice(6, 9)];
  it('is the difference of two boosts from one: B(u₂)B(u₁) = R·B(u₁ ⊕ u₂)', () =>
    fc.assert(
      fc.property(properVelocityUpTo(50), properVelocityUpTo(50), (u1, u2) => {
        const two = multiply(boostMatrix(u2), boostMatrix(u1));
        const one = multiply(lorentz(toMatrix(wignerRotation(u1, u2))), boostMatrix(addVelocities(u1, u2)));
        expectClose(two, one, 1e-13 * (gamma(u1) * gamma(u2)) ** 2);
      }),
    ));
  it('has the angle of the half-rapidity formula', () =>
    fc.assert(
      fc.property(properVelocityUpTo(1000), properVelocityUpTo(1000), (u1, u2) => {
        // tan(θ/2) = sin φ / (cos φ + coth(ζ₁/2) coth(ζ₂/2)), φ between the boosts.
        fc.pre(length(u1) > 1e-6 && length(u2) > 1e-6);
        const sin = length(cross(normalize(u1), normalize(u2)));
        const cos = dot(normalize(u1), normalize(u2));
        fc.pre(cos > -0.999);
        const coths = 1 / (Math.tanh(rapidity(u1) / 2) * Math.tanh(rapidity(u2) / 2));
        expectClose(rotationAngle(wignerRotation(u1, u2)), 2 * Math.atan(sin / (cos + coths)), 1e-10);
      }),
    ));
  it('of perpendicular boosts has the angle tan θ = −γ₁γ₂β₁β₂/(γ₁ + γ₂)', () => {
    const [u1, u2]: Vec3[] = [properVelocity([0.6, 0, 0]), properVelocity([0, 0.8, 0])];
    const [g1, g2] = [5 / 4, 5 / 3];
    const expected = Math.atan((g1 * g2 * 0.6 * 0.8) / (g1 + g2));
    expectClose(
      rotate(wignerRotation(u1, u2), [1, 0, 0]),
      rotate(fromAxisAngle([0, 0, 1], expected), [1, 0, 0]),
      1e-15,
    );
  });
  it('vanishes for parallel boosts, and where two boosts cancel', () =>
    fc.assert(
      fc.property(anyProperVelocity, uniform(-2, 2), (u, s) => {
        expectClose(wignerRotation(u, scale(u, s)), [0, 0, 0, 1], 1e-12);
        expectClose(wignerRotation(u, negate(u)), [0, 0, 0, 1], 1e-15);
      }),
    ));
});

describe('four-acceleration', () => {
  it('is orthogonal to the four-velocity', () =>
    fc.assert(
      fc.property(properVelocityUpTo(1000), direction, (u, a) => {
        const [A0, ...A] = fourAcceleration(u, a);
        const g = gamma(u);
        expectClose(-A0 * g + dot([A[0], A[1], A[2]], u), 0, 1e-14 * g ** 5);
      }),
    ));
  it('has the proper magnitude γ³a parallel and γ²a perpendicular to the velocity', () => {
    const u = properVelocity([0.6, 0, 0]);
    const proper = (a: Vec3) => {
      const [A0, x, y, z] = fourAcceleration(u, a);
      return Math.sqrt(x * x + y * y + z * z - A0 * A0);
    };
    expectClose(proper([2, 0, 0]), 2 * 1.25 ** 3, 1e-14);
    expectClose(proper([0, 2, 0]), 2 * 1.25 ** 2, 1e-14);
    expect(fourAcceleration([0, 0, 0], [1, 2, 3])).toEqual([0, 1, 2, 3]);
  });
});
