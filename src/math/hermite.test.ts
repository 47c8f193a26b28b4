import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, expectClose, uniform } from '../../tests/support/physicsArbitraries.ts';
import { hermite, hermiteRotation, logarithm, slopeRule } from './hermite.ts';
import { conjugate, fromAxisAngle, multiply, type Quat, slerp } from './quat.ts';
import { scale, type Vec3 } from './vec3.ts';

/** The slope at sample k by the rule, for given values. */
function slope(times: readonly number[], values: readonly number[], k: number): number {
  const { middle, share } = slopeRule(times, k);
  const chord = (i: number) => (values[i] - values[i - 1]) / (times[i] - times[i - 1]);
  return share === 0 ? chord(middle) : (1 - share) * chord(middle) + share * chord(middle + 1);
}

describe('slopes at samples', () => {
  it('are those of a parabola through three samples, at the ends too, at any spacing', () =>
    fc.assert(
      fc.property(
        fc.array(uniform(0.3, 2), { minLength: 2, maxLength: 6 }),
        uniform(-2, 2),
        uniform(-2, 2),
        (steps, b, c) => {
          const times = [0];
          for (const step of steps) times.push(times[times.length - 1] + step);
          const values = times.map((t) => 1 + b * t + c * t * t);
          times.forEach((t, k) => {
            expectClose(slope(times, values, k), b + 2 * c * t, 1e-11);
          });
          // So a parabola is reproduced between any two samples.
          const [k, w] = [times.length - 2, 0.3];
          const t = times[k] + w * (times[k + 1] - times[k]);
          const [from, to] = [slope(times, values, k), slope(times, values, k + 1)];
          expectClose(
            hermite(values[k], from, values[k + 1], to, times[k + 1] - times[k], w),
            1 + b * t + c * t * t,
            1e-11,
          );
        },
      ),
    ));
  it('of two samples are that of their chord', () => expect(slope([0, 2], [1, 5], 1)).toBe(2));
  it('do not overshoot at a jump: they are those of the longer side', () => {
    const [times, values] = [
      [0, 1, 1.001, 2],
      [0, 1, 9, 10],
    ];
    expect(slope(times, values, 1)).toBe(1);
    expectClose(slope(times, values, 2), 1 / 0.999, 1e-9);
  });
});

describe('interpolated rotations', () => {
  const turned = (axis: Vec3, angle: number): Quat => fromAxisAngle(axis, angle);
  const apart = (a: Quat, b: Quat) => Math.hypot(...logarithm(multiply(conjugate(a), b)));

  it('at a constant rate are slerp', () =>
    fc.assert(
      fc.property(direction, uniform(-3, 3), direction, uniform(-2.5, 2.5), uniform(0, 1), (n, phi, axis, angle, w) => {
        const a = turned(n, phi);
        const b = multiply(a, turned(axis, angle));
        const rate = scale(axis, angle / 2);
        const between = hermiteRotation({ orientation: a, rate }, { orientation: b, rate }, 2, w);
        expectClose(apart(between, slerp(a, b, w)), 0, 1e-7);
      }),
    ));
  it('begin and end with the given orientations and rates', () =>
    fc.assert(
      fc.property(direction, uniform(-2, 2), direction, uniform(-1, 1), direction, (n, phi, m, r, k) => {
        const a = { orientation: turned(n, phi), rate: scale(m, r) };
        const b = { orientation: multiply(a.orientation, turned(k, 0.7)), rate: scale(n, -r) };
        const at = (w: number) => hermiteRotation(a, b, 1, w);
        expectClose(apart(at(0), a.orientation), 0, 1e-7);
        expectClose(apart(at(1), b.orientation), 0, 1e-7);
        const h = 1e-4;
        const rateOf = (from: Quat, to: Quat) => scale(logarithm(multiply(conjugate(from), to)), 1 / h);
        expectClose(rateOf(at(0), at(h)), a.rate, 2e-3);
        expectClose(rateOf(at(1 - h), at(1)), b.rate, 2e-3);
      }),
    ));
});
