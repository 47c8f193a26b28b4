import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { bigVec, div, dotBig, lengthBig, ONE, sqrt, toNumber } from '../../../tests/support/bigFixed.ts';
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
import { cross, dot, length, negate, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { boost, gamma, oneMinusBetaSquared, properVelocity, velocity } from '../lorentz/boost.ts';
import { fourVector } from '../lorentz/fourVector.ts';
import { relativeVelocity } from '../lorentz/velocity.ts';
import { aberrate } from './aberration.ts';
import {
  apparentSpeedAcross,
  dopplerAtPixel,
  dopplerFactor,
  dopplerFactors,
  emitterDoppler,
  observerDoppler,
  observerDopplers,
} from './doppler.ts';
import {
  blackbodyTemperature,
  bolometricRadiance,
  observedFrequency,
  observedSolidAngle,
  observedWavelength,
  radiancePerFrequency,
  radiancePerWavelength,
} from './radiance.ts';

const speed = uniform(0, 0.9999995);

describe('Doppler factor', () => {
  it('head-on is √((1 + β)/(1 − β)), whether source or observer moves', () =>
    fc.assert(
      fc.property(speed, direction, (beta, n) => {
        const expected = Math.sqrt((1 + beta) / (1 - beta));
        const u = properVelocity(scale(n, beta));
        const tolerance = 1e-15 / (1 - beta);
        expectClose(observerDoppler(n, u) / expected, 1, tolerance);
        expectClose(observerDoppler(n, negate(u)) * expected, 1, tolerance);
        expectClose(emitterDoppler(n, scale(n, -beta)) / expected, 1, tolerance);
        expectClose(emitterDoppler(n, scale(n, beta)) * expected, 1, tolerance);
      }),
    ));
  it('at right angles is γ for a moving observer, 1/γ for a moving emitter', () =>
    fc.assert(
      fc.property(anyProperVelocity, uniform(0, 6), (u, phi) => {
        fc.pre(length(u) > 0);
        const n = perpendicular(u, phi);
        expectClose(observerDoppler(n, u) / gamma(u), 1, 1e-13);
        expectClose(dopplerFactor(n, [0, 0, 0], u) * gamma(u), 1, 1e-13);
      }),
    ));
  it('is at most γ(1 + β), and at least its reciprocal', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, dx]) => {
        const most = gamma(u) + length(u);
        const D = observerDoppler(dx, u);
        expect(D).toBeLessThanOrEqual(most * (1 + 1e-13));
        expect(D).toBeGreaterThanOrEqual((1 - 1e-9) / most);
      }),
    ));
  it('is γ(1 + β·n) to the last digits also where that cancels', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, dx]) => {
        const [x, b] = [bigVec(dx), bigVec(u)];
        const D = sqrt(ONE + dotBig(b, b)) + div(dotBig(b, x), lengthBig(x));
        const expected = toNumber(D);
        expectClose(observerDoppler(dx, u) / expected, 1, 2e-15 * gamma(u));
        expectClose(dopplerFactor(dx, [0, 0, 0], u) * expected, 1, 2e-15 * gamma(u));
      }),
      { numRuns: 300 },
    ));
  it('of an emitter is √(1 − β²)/(1 + β·n) to the last digits, with 1 − β² given', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, dx]) => {
        const [beta, n] = [velocity(u), normalize(dx)];
        const [b, m] = [bigVec(beta), bigVec(n)];
        const oneMinus = ONE - dotBig(b, b);
        // |n| is 1 only to rounding; the formula's n has unit length exactly.
        const expected = toNumber(div(sqrt(oneMinus), ONE + div(dotBig(b, m), lengthBig(m))));
        expectClose(emitterDoppler(n, beta, toNumber(oneMinus)) / expected, 1, 3e-15 * gamma(u));
      }),
    ));
  it('depends on the relative motion only: an observer moving with the emitter sees its rest colour', () =>
    fc.assert(
      fc.property(properVelocityUpTo(100), properVelocityUpTo(100), direction, (uo, ue, n) => {
        expectClose(dopplerFactor(n, uo, uo), 1, 0);
        // In the observer's frame the emitter moves with u_e ⊖ u_o and is seen at n′.
        const there = dopplerFactor(aberrate(n, uo), [0, 0, 0], relativeVelocity(ue, uo));
        expectClose(there / dopplerFactor(n, uo, ue), 1, 1e-14 * (gamma(uo) * gamma(ue)) ** 2);
      }),
    ));
  it("is the ratio of the photon's energies, k·U", () =>
    fc.assert(
      fc.property(properVelocityUpTo(100), direction, (u, n) => {
        // A photon that arrives from n has the wave vector (1, −n); its energy in the observer's frame is D.
        const energy = boost(fourVector(1, negate(n)), u)[0];
        expectClose(observerDoppler(n, u), energy, 1e-14 * gamma(u));
      }),
    ));
  it('per pixel of a static world is that of the light’s direction', () =>
    fc.assert(
      fc.property(velocityAndOffset, ([u, dx]) => {
        expectClose(dopplerAtPixel(aberrate(normalize(dx), u), u) / observerDoppler(dx, u), 1, 1e-14 * gamma(u) ** 2);
      }),
    ));
  it('is 1 at rest, and finite for the zero vector', () => {
    expect(observerDoppler([1, 2, 3], [0, 0, 0])).toBe(1);
    expect(emitterDoppler([0, 0, 1], [0, 0, 0])).toBe(1);
    expect(observerDoppler([0, 0, 0], [0.75, 0, 0])).toBe(1.25);
  });
  it('maps whole arrays', () =>
    fc.assert(
      fc.property(anyProperVelocity, fc.array(fc.tuple(offset, anyProperVelocity), { maxLength: 5 }), (u, rows) => {
        const dx = Float64Array.from(rows.flatMap(([x]) => x));
        const emitters = Float64Array.from(rows.flatMap(([, v]) => v));
        expect([...observerDopplers(dx, u)]).toEqual(rows.map(([x]) => observerDoppler(x, u)));
        expect([...dopplerFactors(dx, u, emitters)]).toEqual(rows.map(([x, v]) => dopplerFactor(x, u, v)));
      }),
    ));
});

describe('apparent speed', () => {
  it('is β sin θ/(1 − β cos θ), at most γβ, at cos θ = β', () =>
    fc.assert(
      fc.property(uniform(0, 0.999), uniform(0, Math.PI), (beta, theta) => {
        // The source is at +z and moves at θ from the line toward the observer.
        const across = apparentSpeedAcross([0, 0, 1], [beta * Math.sin(theta), 0, -beta * Math.cos(theta)]);
        expectClose(across, (beta * Math.sin(theta)) / (1 - beta * Math.cos(theta)), 1e-11);
        const best = apparentSpeedAcross([0, 0, 1], [beta * Math.sqrt(1 - beta * beta), 0, -beta * beta]);
        expectClose(best, beta / Math.sqrt(1 - beta * beta), 1e-11);
        expect(across).toBeLessThanOrEqual(best + 1e-11);
      }),
    ));
});

describe('radiance', () => {
  const [h, c, k] = [6.62607015e-34, 299792458, 1.380649e-23];
  const planckNu = (T: number) => (nu: number) => (2 * h * nu ** 3) / (c * c * Math.expm1((h * nu) / (k * T)));
  const planckLambda = (T: number) => (l: number) => (2 * h * c * c) / (l ** 5 * Math.expm1((h * c) / (l * k * T)));
  const factor = uniform(-1, 1).map((e) => 10 ** e);
  const wavelength = uniform(2e-7, 2e-6);

  it('of a blackbody is that of a blackbody at D T, by frequency and by wavelength', () =>
    fc.assert(
      fc.property(factor, wavelength, (D, lambda) => {
        const nu = c / lambda;
        const hot = blackbodyTemperature(5800, D);
        expectClose(radiancePerFrequency(planckNu(5800), nu, D) / planckNu(hot)(nu), 1, 1e-12);
        expectClose(radiancePerWavelength(planckLambda(5800), lambda, D) / planckLambda(hot)(lambda), 1, 1e-12);
        // Stefan and Boltzmann: T⁴.
        expectClose(bolometricRadiance(1, D) / (hot / 5800) ** 4, 1, 1e-13);
      }),
    ));
  it('preserves L_ν/ν³, and shifting forth and back restores the colour', () =>
    fc.assert(
      fc.property(factor, wavelength, (D, lambda) => {
        const nu = c / lambda;
        const seen = observedFrequency(nu, D);
        const invariant = planckNu(5800)(nu) / nu ** 3;
        expectClose(radiancePerFrequency(planckNu(5800), seen, D) / seen ** 3 / invariant, 1, 1e-12);
        expectClose(observedFrequency(observedFrequency(nu, D), 1 / D) / nu, 1, 1e-15);
        expectClose((observedWavelength(lambda, D) * seen) / c, 1, 1e-15);
      }),
    ));
  it('solid angles shrink as aberration concentrates directions', () =>
    fc.assert(
      fc.property(properVelocityUpTo(10), direction, (u, n) => {
        const step = 1e-5;
        const [e1, e2] = [perpendicular(n), perpendicular(n, Math.PI / 2)];
        const turned = (e: Vec3, s: number): Vec3 => aberrate([n[0] + s * e[0], n[1] + s * e[1], n[2] + s * e[2]], u);
        const across = (e: Vec3): Vec3 => {
          const [a, b] = [turned(e, step), turned(e, -step)];
          return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        };
        const patch = dot(cross(across(e1), across(e2)), aberrate(n, u)) / (4 * step * step);
        const expected = observedSolidAngle(1, observerDoppler(n, u));
        expectClose(patch / expected, 1, 1e-5);
      }),
    ));
  it('of a moving emitter, seen at rest, uses the same D', () => {
    expectClose(emitterDoppler([0, 0, 1], [0, 0, -0.6], oneMinusBetaSquared([0, 0, 0.6])), 2, 1e-15);
  });
});
