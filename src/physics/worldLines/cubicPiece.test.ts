import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  direction,
  expectClose,
  magnitude,
  offset,
  properVelocityUpTo,
  uniform,
} from '../../../tests/support/physicsArbitraries.ts';
import { add, addScaled, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { boost, gamma, velocity } from '../lorentz/boost.ts';
import { fourVector, spatial } from '../lorentz/fourVector.ts';
import {
  type CubicPiece,
  controlVelocities,
  cubicAt,
  cubicCrossing,
  cubicEmission,
  subluminalBend,
  withBend,
} from './cubicPiece.ts';
import { polylineEmission } from './emission.ts';
import type { CubicLine } from './kinds/cubicLine.ts';
import { emissionEvent } from './lightCone.ts';
import { positionAt, velocityAt } from './worldLine.ts';

const slow = properVelocityUpTo(5).map(velocity);
/** A piece given by its control velocities [c], all below 1. */
const piece = fc.tuple(offset, slow, slow, slow, magnitude(-2, 2)).map(([a, va, middle, vb, span]): CubicPiece => {
  return { a, va, vb, span, b: addScaled(a, add(add(va, middle), vb), span / 3) };
});

describe('a cubic piece', () => {
  it('reproduces any cubic of time, x = a + bt + ct² + dt³, with its velocities', () => {
    const number = uniform(-2, 2);
    const vector = fc.tuple(number, number, number);
    fc.assert(
      fc.property(vector, vector, vector, vector, uniform(0.1, 3), uniform(0, 1), (a, b, c, d, span, w) => {
        const at = (t: number): Vec3 => addScaled(addScaled(addScaled(a, b, t), c, t * t), d, t ** 3);
        const speed = (t: number): Vec3 => addScaled(addScaled(b, c, 2 * t), d, 3 * t * t);
        const { x, v } = cubicAt({ a, va: b, b: at(span), vb: speed(span), span }, w * span);
        expectClose(x, at(w * span), 1e-13 * 100);
        expectClose(v, speed(w * span), 1e-12 * 100);
      }),
    );
  });
  it('has no speed above that of its fastest control velocity', () =>
    fc.assert(
      fc.property(piece, uniform(0, 1), (p, w) => {
        const most = Math.max(...controlVelocities(p).map(length));
        expect(length(cubicAt(p, w * p.span).v)).toBeLessThanOrEqual(most * (1 + 1e-9) + 1e-12);
      }),
    ));
  it('is limited in speed by the least possible reduction of its bend', () =>
    fc.assert(
      fc.property(piece, uniform(0.5, 3), (p, part) => {
        const chord = length(scale(sub(p.b, p.a), 1 / p.span));
        const limit = chord * part + 1e-3;
        const bend = subluminalBend(p, limit);
        const fastest = (share: number) => Math.max(...controlVelocities(withBend(p, share)).map(length));
        if (chord >= limit) expect(bend).toBe(0);
        else expect(fastest(bend)).toBeLessThanOrEqual(limit * (1 + 1e-9));
        if (bend < 1 && chord < limit) expectClose(fastest(bend), limit, 1e-7 * limit);
        expect(withBend(p, 1)).toBe(p);
      }),
    ));
});

describe('its emission event', () => {
  it('is the one whose light cone contains the observer, at any position', () =>
    fc.assert(
      fc.property(piece, direction, magnitude(-3, 5), uniform(0.001, 0.999), (p, n, far, w) => {
        const { x, v } = cubicAt(p, w * p.span);
        // The observer is at x + far n when the light arrives.
        const shifted = { ...p, a: sub(p.a, addScaled(x, n, far)), b: sub(p.b, addScaled(x, n, far)) };
        const seen = cubicEmission(shifted, -w * p.span - far);
        const size = far + length(p.a) + p.span;
        const towards = 1 - dot(n, v);
        expectClose(seen.offset, scale(n, -far), (1e-13 * size) / towards);
        expect(seen.delay).toBe(length(seen.offset));
      }),
      { numRuns: 500 },
    ));
  it('of a straight piece equals that of the polyline', () =>
    fc.assert(
      fc.property(offset, slow, magnitude(-2, 2), uniform(0, 1), (a, v, span, w) => {
        const b = addScaled(a, v, span);
        const tA = -length(a) - w * span * (1 - length(v)) * 0.9;
        fc.pre(length(b) + tA + span >= 0);
        const size = length(a) + span;
        const got = cubicEmission({ a, va: v, b, vb: v, span }, tA);
        expectClose(got.offset, polylineEmission(a, tA, b, tA + span).offset, 1e-12 * size);
      }),
    ));
  it('is frame independent: the same event, boosted', () =>
    fc.assert(
      fc.property(piece, properVelocityUpTo(5), uniform(0.01, 0.99), (p, u, w) => {
        const { x } = cubicAt(p, w * p.span);
        const seen = cubicEmission({ ...p, a: sub(p.a, x), b: sub(p.b, x) }, -w * p.span);
        const moved = boost(fourVector(-seen.delay, seen.offset), u);
        expectClose(length(spatial(moved)), -moved[0], 1e-9 * (1 + length(p.a) + p.span) * gamma(u));
      }),
    ));
});

it('crosses the observer’s now where Δt′ = 0', () =>
  fc.assert(
    fc.property(piece, properVelocityUpTo(20), uniform(0, 1), (p, u, w) => {
      const { x } = cubicAt(p, w * p.span);
      const tA = dot(u, x) / gamma(u) - w * p.span;
      const size = length(p.a) + p.span;
      expectClose(cubicCrossing(p, tA, u), w * p.span, 1e-12 * size * gamma(u) ** 2 * 100);
    }),
  ));

describe('a cubic world line', () => {
  const line: CubicLine = {
    kind: 'cubic',
    times: Float64Array.of(0, 1, 3),
    // x = t³/20 − t/10 and its slopes.
    positions: Float64Array.from([0, 1, 3].flatMap((t) => [t ** 3 / 20 - t / 10, 0, 0])),
    velocities: Float64Array.from([0, 1, 1, 3].flatMap((t) => [(3 * t * t) / 20 - 1 / 10, 0, 0])),
  };
  it('is at rest outside its samples', () => {
    for (const t of [-1, 3, 9]) expect(velocityAt(line, t, 10)).toEqual([0, 0, 0]);
    expect(positionAt(line, 9, 10)).toEqual(positionAt(line, 3, 10));
  });
  it('has continuous velocity at samples, and so continuous D', () => {
    const speed = (t: number) => velocityAt(line, t, 10)[0];
    expectClose(speed(1 - 1e-9), speed(1), 1e-8);
    const beside = (t: number) => emissionEvent(line, { t, position: [0, 5, 0] }, 10)?.velocity[0] ?? Number.NaN;
    // Seen at the sample: |x − x_o|/c later.
    const t = 1 + Math.hypot(positionAt(line, 1, 10)[0], 5) / 10;
    expectClose(beside(t - 1e-7), beside(t + 1e-7), 1e-6);
    expectClose(beside(t), (3 - 2) / 20, 1e-12);
  });
});
