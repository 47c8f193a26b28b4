import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { worldTimesOf } from '../../flight/spacing.ts';
import { properTimeBetween } from '../../physics/worldLines/properTime.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { IDENTITY_POSE, restingAt } from '../../scene/defaults.ts';
import type { RigidMotion } from '../../scene/types.ts';
import type { ObserverSetup } from '../../scene/view/observerPath.ts';
import { spacedFrames } from './frameSpacing.ts';

const C = 10;
const frames = Array.from({ length: 9 }, (_, i) => ({ number: i, t: i }));
const riding = (motion: RigidMotion): ObserverSetup => ({ camera: { path: '/Eye', motion, fovY: 1 } });
const spaced = (setup: ObserverSetup) => spacedFrames(frames, 'proper', setup, C).map(({ t }) => t);

/** Away at 0.8 c for 5 s, and back. */
const TWIN = {
  kind: 'sampled',
  times: Float64Array.of(0, 5, 10),
  poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 40, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1),
} as const;

describe('frames in proper time', () => {
  it('of constant proper acceleration are at t = (c/a) sinh(aτ/c), up to rapidity 300', () => {
    fc.assert(
      fc.property(fc.double({ min: 1e-3, max: 300, noNaN: true }), (a) => {
        const motion = { kind: 'hyperbolic', pose: IDENTITY_POSE, properAcceleration: [0, 0, -a], t0: 0 } as const;
        const few = [0.5, 1, 7, 10].filter((tau) => (a * tau) / C <= 300);
        spacedFrames(
          few.map((t) => ({ t })),
          'proper',
          riding(motion),
          C,
        ).forEach(({ t }, i) => {
          const x = (a * few[i]!) / C;
          // A relative error of the rapidity is one of e^x times x.
          expect(Math.abs(t / ((C / a) * Math.sinh(x)) - 1)).toBeLessThan(1e-14 * (10 + x * x));
        });
      }),
    );
  });

  it('of a twin at 0.8 c come home after 6 s, at world time 10 s; then both clocks run alike', () => {
    spaced(riding(TWIN)).forEach((t, tau) => {
      expect(t).toBeCloseTo(tau <= 6 ? (tau * 5) / 3 : tau + 4, 12);
    });
  });

  it('before the time at which the clock is set are earlier', () => {
    const motion = { kind: 'uniform', pose: IDENTITY_POSE, velocity: [6, 0, 0] } as const;
    const earlier = spacedFrames([{ t: -4 }, { t: 0 }, { t: 4 }], 'proper', riding(motion), C).map(({ t }) => t);
    [-5, 0, 5].forEach((t, i) => {
      expect(earlier[i]).toBeCloseTo(t, 12);
    });
  });

  it('of one who coasts begin with the first frame', () => {
    const setup: ObserverSetup = { camera: { path: '/Eye', motion: restingAt([0, 0, 0]), fovY: 1 }, beta: [0, 0.6, 0] };
    const times = spacedFrames([{ t: 3 }, { t: 7 }], 'proper', setup, C).map(({ t }) => t);
    expect(times[0]).toBeCloseTo(3, 12);
    expect(times[1]).toBeCloseTo(8, 12);
    expect(() => spaced({ ...setup, stayInPlace: true })).toThrow(/who moves/);
    expect(() => spaced({ ...riding(TWIN), beta: [0.1, 0, 0] })).toThrow(/who moves/);
    expect(() => spaced(riding(restingAt([0, 0, 0])))).toThrow(/who moves/);
  });

  it('in world time are as they were', () => {
    expect(spacedFrames(frames, 'world', riding(restingAt([0, 0, 0])), C)).toBe(frames);
  });
});

describe('proper time', () => {
  it('around a circle and along a straight cubic is √(1 − β²) of the world’s', () => {
    const circle: WorldLine = {
      kind: 'circular',
      center: [0, 0, 0],
      axis: [0, 0, 1],
      arm: [3, 0, 1],
      angularVelocity: 2,
    };
    expect(properTimeBetween(circle, 1, 6, C)).toBeCloseTo(4, 12);
    const straight = { times: Float64Array.of(0, 1, 3), positions: Float64Array.of(0, 0, 0, 6, 0, 0, 18, 0, 0) };
    const velocities = Float64Array.of(6, 0, 0, 6, 0, 0, 6, 0, 0, 6, 0, 0);
    expect(properTimeBetween({ kind: 'cubic', ...straight, velocities }, -1, 4, C)).toBeCloseTo(1 + 2.4 + 1, 9);
  });

  it('along a cubic at constant acceleration v = at is ∫√(1 − (at/c)²) dt', () => {
    // x = t²: a piece with v = 0 and v = 8 at 4 s. ∫₀^β √(1 − s²) ds = (asin β + β √(1 − β²))/2.
    const line: WorldLine = {
      kind: 'cubic',
      times: Float64Array.of(0, 4),
      positions: Float64Array.of(0, 0, 0, 16, 0, 0),
      velocities: Float64Array.of(0, 0, 0, 8, 0, 0),
    };
    expect(properTimeBetween(line, 0, 4, C)).toBeCloseTo((5 * (Math.asin(0.8) + 0.8 * 0.6)) / 2, 5);
  });

  it('is additive, and negative backwards', () => {
    const time = fc.double({ min: -3, max: 13, noNaN: true });
    const line: WorldLine = {
      kind: 'polyline',
      times: TWIN.times,
      positions: Float64Array.of(0, 0, 0, 40, 0, 0, 0, 0, 0),
    };
    const between = (a: number, b: number) => properTimeBetween(line, a, b, C);
    fc.assert(
      fc.property(time, time, time, (a, b, d) => {
        expect(between(a, b) + between(b, d)).toBeCloseTo(between(a, d), 9);
      }),
    );
  });

  it('of what is as fast as light never comes', () => {
    expect(worldTimesOf({ setAt: 0, elapsed: () => 0 }, [0, 1])).toBeUndefined();
  });
});
