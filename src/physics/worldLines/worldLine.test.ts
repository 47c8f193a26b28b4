import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, expectClose, magnitude, offset, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { cross, dot, length, normalize, scale, sub } from '../../math/vec3.ts';
import { circleAt } from './kinds/circularLine.ts';
import type { CubicLine } from './kinds/cubicLine.ts';
import type { PolylineLine } from './kinds/polylineLine.ts';
import { restsOutsideSamples, samplesUntil } from './samples.ts';
import {
  asInertial,
  asPolyline,
  hullPoints,
  positionAt,
  referencePosition,
  velocityAt,
  type WorldLine,
} from './worldLine.ts';

const time = uniform(-100, 100);

const zigzag: PolylineLine = {
  kind: 'polyline',
  times: Float64Array.of(1, 2, 4),
  positions: Float64Array.of(0, 0, 0, 3, 0, 0, 3, 8, 0),
};

describe('world lines', () => {
  it('uniform: x₀ + v t', () => {
    const w: WorldLine = { kind: 'uniform', position: [1, 2, 3], velocity: [4, 0, -1] };
    expect(positionAt(w, 2, 10)).toEqual([9, 2, 1]);
    expect(velocityAt(w, 2, 10)).toEqual([4, 0, -1]);
  });
  it('hyperbolic: x² − c²t² = (c²/a)² about the centre, v = c tanh(aτ/c)', () =>
    fc.assert(
      fc.property(direction, magnitude(-2, 2), time, magnitude(0, 2), (n, a, t, c) => {
        const w: WorldLine = { kind: 'hyperbolic', position: [5, 6, 7], properAcceleration: scale(n, a), t0: 3 };
        const l = (c * c) / a;
        const along = dot(sub(positionAt(w, t, c), w.position), n);
        const s = c * (t - 3);
        expectClose((along + l - s) * (along + l + s), l * l, 1e-11 * (l + Math.abs(s)) ** 2);
        const tau = (c / a) * Math.asinh((a * (t - 3)) / c);
        expectClose(velocityAt(w, t, c), scale(n, c * Math.tanh((a * tau) / c)), 1e-13 * c);
      }),
    ));
  it('hyperbolic: at²/2 for a tiny acceleration, at rest for none', () => {
    const slow: WorldLine = { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: [1e-12, 0, 0], t0: 0 };
    expectClose(positionAt(slow, 10, 3e8)[0] / 5e-11, 1, 1e-15);
    const still: WorldLine = { ...slow, properAcceleration: [0, 0, 0] };
    expect(positionAt(still, 10, 3e8)).toEqual([0, 0, 0]);
    expect(velocityAt(still, 10, 3e8)).toEqual([0, 0, 0]);
  });
  it('circular: keeps its distance from the axis, right-handed, with v = ω × r', () =>
    fc.assert(
      fc.property(direction, offset, magnitude(-3, 1), time, (axis, arm, omega, t) => {
        const w: WorldLine = { kind: 'circular', center: [1, 2, 3], axis, arm, angularVelocity: omega };
        const r = length(arm) + 4;
        const from = sub(positionAt(w, t, 1), w.center);
        expectClose(dot(from, axis), dot(arm, axis), 1e-13 * r);
        expectClose(length(cross(from, axis)), length(cross(arm, axis)), 1e-13 * r);
        expectClose(velocityAt(w, t, 1), scale(cross(axis, from), omega), 1e-13 * r * omega);
        const { center, arm: turning } = circleAt(w, t);
        expectClose(dot(turning, axis), 0, 1e-13 * r);
        const place = positionAt(w, t, 1);
        expectClose(
          center.map((x, i) => x + turning[i]),
          place,
          1e-13 * r,
        );
      }),
    ));
  it('circular: a quarter turn', () => {
    const w: WorldLine = { kind: 'circular', center: [0, 0, 0], axis: [0, 0, 1], arm: [2, 0, 0], angularVelocity: 0.5 };
    expectClose(positionAt(w, Math.PI, 1), [0, 2, 0], 1e-15);
    expectClose(velocityAt(w, Math.PI, 1), [-1, 0, 0], 1e-15);
  });
  it('velocity is the slope of position', () =>
    fc.assert(
      fc.property(direction, time, (n, t) => {
        const lines: WorldLine[] = [
          { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: scale(n, 2), t0: 1 },
          { kind: 'circular', center: [0, 0, 0], axis: n, arm: normalize([1, 2, 3]), angularVelocity: 0.7 },
        ];
        for (const w of lines) {
          const h = 1e-4;
          const slope = scale(sub(positionAt(w, t + h, 10), positionAt(w, t - h, 10)), 1 / (2 * h));
          expectClose(velocityAt(w, t, 10), slope, 1e-5);
        }
      }),
    ));
});

const bent: CubicLine = {
  kind: 'cubic',
  times: zigzag.times,
  positions: zigzag.positions,
  velocities: Float64Array.of(0, 2, 0, 6, -1, 3, 6, -1, 3, 0, 9, 1),
};
const everyKind: readonly WorldLine[] = [
  { kind: 'static', position: [1, 2, 3] },
  { kind: 'uniform', position: [1, 2, 3], velocity: [4, 0, -1] },
  { kind: 'hyperbolic', position: [1, 2, 3], properAcceleration: [1, -2, 3], t0: 2 },
  { kind: 'circular', center: [1, 2, 3], axis: normalize([1, 2, -1]), arm: [2, 1, 1], angularVelocity: 1.3 },
  zigzag,
  bent,
];

describe('a world line of any kind', () => {
  it('stays between two times in the convex hull of their places and the hull points', () =>
    fc.assert(
      fc.property(fc.constantFrom(...everyKind), time, magnitude(-3, 1), uniform(0, 1), direction, (w, t, s, k, n) => {
        const [from, to] = [t / 10, t / 10 + s];
        const hull = [positionAt(w, from, 10), positionAt(w, to, 10), ...hullPoints(w, from, to, 10)];
        const along = dot(positionAt(w, from + k * s, 10), n);
        expect(along).toBeLessThanOrEqual(Math.max(...hull.map((x) => dot(x, n))) + 1e-9);
      }),
      { numRuns: 3000 },
    ));
  it('is inertial or a polyline only where these are the same places', () => {
    for (const w of everyKind) {
      const [inertial, samples] = [asInertial(w), asPolyline(w)];
      if (inertial) expect(positionAt({ kind: 'uniform', ...inertial }, 3, 10)).toEqual(positionAt(w, 3, 10));
      if (samples) expect(positionAt({ ...samples, kind: 'polyline' }, 3, 10)).toEqual(positionAt(w, 3, 10));
    }
    expect(everyKind.map((w) => asInertial(w) !== undefined)).toEqual([true, true, false, false, false, false]);
    expect(everyKind.map((w) => asPolyline(w) !== undefined)).toEqual([false, false, false, false, true, false]);
  });
  it('has a place of reference', () => {
    const referenceTimes = [0, 0, 2, 0, 1, 1];
    everyKind.forEach((w, i) => {
      expectClose(referencePosition(w), positionAt(w, referenceTimes[i], 10), 1e-15);
    });
  });
});

describe('polyline', () => {
  it('is straight between samples, and at rest outside', () => {
    expect(positionAt(zigzag, 0, 1)).toEqual([0, 0, 0]);
    expect(positionAt(zigzag, 1.5, 1)).toEqual([1.5, 0, 0]);
    expect(positionAt(zigzag, 3, 1)).toEqual([3, 4, 0]);
    expect(positionAt(zigzag, 9, 1)).toEqual([3, 8, 0]);
  });
  it('has the velocity of the piece that begins at a sample', () => {
    expect([0, 1, 1.5, 2, 4, 9].map((t) => velocityAt(zigzag, t, 1))).toEqual([
      [0, 0, 0],
      [3, 0, 0],
      [3, 0, 0],
      [0, 4, 0],
      [0, 0, 0],
      [0, 0, 0],
    ]);
    expect([0, 1, 3.9, 4].map((t) => restsOutsideSamples(zigzag, t))).toEqual([true, false, false, true]);
  });
  it('counts the samples up to a time like a linear search', () =>
    fc.assert(
      fc.property(
        fc.uniqueArray(fc.integer({ min: -9, max: 9 }), { minLength: 1 }),
        fc.integer({ min: -10, max: 10 }),
        (raw, t) => {
          const times = Float64Array.from(raw).sort();
          expect(samplesUntil(times, t)).toBe(raw.filter((x) => x <= t).length);
        },
      ),
    ));
  it('of one sample is at rest', () => {
    const point: PolylineLine = { kind: 'polyline', times: Float64Array.of(3), positions: Float64Array.of(1, 2, 3) };
    expect([2, 3, 4].map((t) => positionAt(point, t, 1))).toEqual([
      [1, 2, 3],
      [1, 2, 3],
      [1, 2, 3],
    ]);
    expect(velocityAt(point, 3, 1)).toEqual([0, 0, 0]);
  });
});
