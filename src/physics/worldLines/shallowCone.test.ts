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
import { cross, dot, length, normalize, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { boost, gamma, properVelocity } from '../lorentz/boost.ts';
import { fourVector, spatial } from '../lorentz/fourVector.ts';
import { apparentPosition } from '../optics/apparentPosition.ts';
import { pastLightCone } from './lightCone.ts';
import { shallowCone, shallowPosition } from './shallowCone.ts';
import { simultaneitySlice, simultaneousPosition } from './simultaneity.ts';
import { positionAt, type WorldLine } from './worldLine.ts';

const C = 10;
const slopes = uniform(1e-3, 0.999);
const observers = fc.record({ t: uniform(-3, 3), position: offset, u: properVelocityUpTo(20) });

/** A wave in space of ten samples, slower than 0.9 c. */
const wavePositions = (at: Vec3): Float64Array =>
  Float64Array.from({ length: 30 }, (_, i) => at[i % 3]! + 3 * Math.sin(0.7 * Math.floor(i / 3) + (i % 3)));
const times = Float64Array.from({ length: 10 }, (_, k) => -3 + 0.6 * k);

const lines: fc.Arbitrary<WorldLine> = fc
  .tuple(offset, direction, uniform(0, 0.95), uniform(0.1, 60))
  .chain(([position, n, beta, acceleration]) => {
    const radius = 2;
    return fc.constantFrom<WorldLine>(
      { kind: 'static', position },
      { kind: 'uniform', position, velocity: scale(n, beta * C) },
      { kind: 'hyperbolic', position, properAcceleration: scale(n, acceleration), t0: beta },
      { kind: 'polyline', times, positions: wavePositions(position) },
      {
        kind: 'circular',
        center: position,
        axis: n,
        arm: scale(normalize(cross(n, [0.36, 0.48, 0.8]), [1, 0, 0]), radius),
        angularVelocity: (beta * C) / radius,
      },
    );
  });

describe('the cone ct′ = −λr′', () => {
  it('is met by each world line where the boosted event says so', () =>
    fc.assert(
      fc.property(lines, observers, slopes, (line, { u, ...observer }, slope) => {
        const { offset: dx, ahead } = shallowCone(slope).intersect(line, observer, u, C)!;
        const [ct, ...place] = boost(fourVector(ahead, dx), u);
        const size = gamma(u) * (Math.abs(ahead) + length(dx));
        expectClose(ct, -slope * length(place), 1e-9 * size);
        // And it is an event of the line.
        const there = sub(positionAt(line, observer.t + ahead / C, C), observer.position);
        expectClose(length(sub(there, dx)), 0, 1e-9 * (size + length(observer.position) + 10));
      }),
      { numRuns: 400 },
    ));

  it('is met by a straight line as the formula for boosted lines has it', () =>
    fc.assert(
      fc.property(offset, properVelocityUpTo(20), properVelocityUpTo(20), slopes, (d, v, u, slope) => {
        const velocity = scale(v, 1 / gamma(v));
        const line = { kind: 'uniform', position: d, velocity } as const;
        const { ahead } = shallowCone(slope).intersect(line, { t: 0, position: ZERO }, u, 1)!;
        // (a, p) + s(b, q): docs/physics.md §5.8.
        const [a, ...p] = boost(fourVector(0, d), u);
        const [b, ...q] = boost(fourVector(1, velocity), u);
        const B = a * b - slope * slope * dot(p, q);
        const across = [0, 1, 2].map((k) => a * q[k]! - b * p[k]!) as unknown as Vec3;
        const root = slope * Math.sqrt(dot(across, across) - slope ** 2 * dot(cross(p, q), cross(p, q)));
        const s = (-B - root) / (b * b - slope * slope * dot(q, q));
        expectClose(ahead, s, 1e-7 * (Math.abs(s) + length(d)) * gamma(u) * gamma(v));
      }),
      { numRuns: 300 },
    ));

  it('goes from the slice to the past light cone, always to earlier events', () =>
    fc.assert(
      fc.property(lines, observers, (line, { u, ...observer }) => {
        const events = [0.001, 0.2, 0.5, 0.8, 0.999].map(
          (slope) => shallowCone(slope).intersect(line, observer, u, C)!.ahead,
        );
        const last = simultaneitySlice(line, observer, u, C).ahead;
        const seen = pastLightCone(line, observer, C);
        const all = [last, ...events, ...(seen ? [-seen.delay] : [])];
        const size = 1e-9 * gamma(u) ** 2 * (Math.abs(last) + Math.abs(all.at(-1)!) + length(observer.position) + 10);
        for (const [i, ahead] of all.entries()) if (i > 0) expect(ahead).toBeLessThanOrEqual(all[i - 1]! + size);
      }),
      { numRuns: 300 },
    ));

  it('has events of a line behind the horizon of light', () => {
    // Light of it reaches nobody at the origin before t = 0.1 s.
    const line = { kind: 'hyperbolic', position: [-10, 0, 0], properAcceleration: [-10, 0, 0], t0: 3 } as const;
    const observer = { t: 0.1, position: [35, 0, 0] } as const;
    expect(pastLightCone(line, observer, C)).toBeUndefined();
    for (const slope of [0.3, 0.9, 0.99]) {
      const { offset: dx, ahead } = shallowCone(slope).intersect(line, observer, ZERO, C)!;
      expectClose(ahead, -slope * length(dx), 1e-9 * length(dx));
    }
  });

  it('says how late events are, and how fast that grows', () =>
    fc.assert(
      fc.property(offset, properVelocityUpTo(5), properVelocityUpTo(5), slopes, (d, v, u, slope) => {
        const cone = shallowCone(slope);
        const [vx, vy, vz] = scale(v, 1 / gamma(v));
        const s = cone.crossingTime(0, ...d, vx, vy, vz, u, gamma(u));
        const at = (after: number) =>
          [d[0] + vx * (s + after), d[1] + vy * (s + after), d[2] + vz * (s + after), s + after] as const;
        const size = gamma(u) * (length(d) + Math.abs(s));
        expectClose(cone.lateness(...at(0), u, gamma(u)), 0, 1e-10 * size * gamma(v));
        const h = 1e-4 * length(d);
        const difference = cone.lateness(...at(h), u, gamma(u)) - cone.lateness(...at(-h), u, gamma(u));
        const rate = cone.latenessRate(...at(0), vx, vy, vz, u, gamma(u));
        expect(rate).toBeGreaterThan(0);
        if (length(at(0).slice(0, 3) as unknown as Vec3) > 0.3 * length(d))
          expectClose(difference / (2 * h), rate, 1e-2 * gamma(u) * gamma(v));
        expectClose(cone.timeAt(at(0).slice(0, 3) as unknown as Vec3, u), at(0)[3], 1e-8 * size);
      }),
      { numRuns: 300 },
    ));
});

describe('places on the cone', () => {
  it('are those of the boosted events', () =>
    fc.assert(
      fc.property(offset, properVelocityUpTo(50), slopes, (dx, u, slope) => {
        const time = shallowCone(slope).timeAt(dx, u);
        const place = spatial(boost(fourVector(time, dx), u));
        expectClose(length(sub(shallowPosition(dx, u, slope), place)), 0, 1e-11 * gamma(u) ** 2 * length(dx));
      }),
      { numRuns: 300 },
    ));

  it('are those of the slice and of light at the ends', () =>
    fc.assert(
      fc.property(offset, anyProperVelocity, (dx, u) => {
        expectClose(length(sub(shallowPosition(dx, u, 0), simultaneousPosition(dx, u))), 0, 1e-12 * length(dx));
      }),
    ));

  it('of what is ahead are at r′ = S/(1 − λβ)', () => {
    // Of what rests in the observer's own frame nothing is displaced, at any λ.
    const at: Vec3 = [1, 2, -3];
    for (const slope of [0.2, 0.7]) expect(shallowPosition(at, ZERO, slope)).toEqual(at);
    const u = properVelocity([0, 0, -0.8]);
    // 5 m ahead: r′ = S/(1 − λβ), S = 3 m.
    for (const slope of [0.25, 0.5, 0.75])
      expectClose(-shallowPosition([0, 0, -5], u, slope)[2], 3 / (1 - 0.8 * slope), 1e-12);
    expectClose(apparentPosition([0, 0, -5], u)[2], -15, 1e-12);
  });
});
