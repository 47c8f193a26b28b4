import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { properVelocityUpTo, uniform } from '../../../tests/support/physicsArbitraries.ts';
import type { EventMark } from '../../graph/document/document.ts';
import { scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { gamma, properVelocity, velocity } from '../../physics/lorentz/boost.ts';
import type { Clock } from '../../scene/clocks/clock.ts';
import { FOREVER, restingAt } from '../../scene/defaults.ts';
import { originWorldLine } from '../../scene/motion/motion.ts';
import { compareMarks, markOwn, markSeen, marksCsv } from './stopwatch.ts';

const c = 10;
const still = (position: Vec3): Clock => ({
  path: '/Lamp',
  carriers: [{ line: originWorldLine(restingAt(position)), lifetime: FOREVER }],
});
const coasting = (u: Vec3, tau: number) => ({
  t: gamma(u) * tau,
  position: scale(u, c * tau),
  u,
  properTime: tau,
});
const seen = (name: string, clock: Clock, observer: ReturnType<typeof coasting>): EventMark => {
  const mark = markSeen(name, clock, observer, c);
  if (typeof mark === 'string') throw new Error(mark);
  return mark;
};

describe('two marked events', () => {
  it('of a ship that coasts are timelike, and its clock counts √(−Δs²)/c', () =>
    fc.assert(
      fc.property(properVelocityUpTo(20), uniform(-5, 5), uniform(0.1, 9), (u, from, tau) => {
        const found = compareMarks(markOwn('a', coasting(u, from)), markOwn('b', coasting(u, from + tau)), c);
        expect(found.separateness).toBe('timelike');
        expect(Math.sqrt(-found.interval) / c / tau).toBeCloseTo(1, 6);
        expect(found.dTau).toBeCloseTo(tau, 12);
        expect(found.dOwn).toBeCloseTo(tau, 12);
        expect(found.dtObserver / tau).toBeCloseTo(1, 6);
        expect(found.dt / (gamma(u) * tau)).toBeCloseTo(1, 12);
        expect(found.distance / (Math.hypot(...u) * c * tau) || 1).toBeCloseTo(1, 12);
      }),
    ));

  it('are lightlike where one sees the other', () =>
    fc.assert(
      fc.property(properVelocityUpTo(20), uniform(-9, 9), uniform(-30, 30), uniform(1, 30), (u, tau, x, y) => {
        const observer = coasting(u, tau);
        const found = compareMarks(seen('a', still([x, y, 0]), observer), markOwn('b', observer), c);
        expect(found.separateness).toBe('lightlike');
        expect(found.dTau).toBeUndefined();
        expect(found.dOwn).toBe(0);
        expect(found.dt * c).toBeCloseTo(found.distance, 6);
      }),
    ));

  it('that are spacelike follow each other one way or the other, as the observer moves', () => {
    const u = properVelocity([0.6, 0, 0]);
    const mark = (time: number, x: number): EventMark => ({
      ...markOwn('', { t: time, position: [x, 0, 0], u, properTime: 0 }),
    });
    // Δt′ = γ(Δt − βΔx/c) = 1.25 (0.1 − 0.3) s.
    const found = compareMarks(mark(1, 2), mark(1.1, 7), c);
    expect(found.separateness).toBe('spacelike');
    expect(found.interval).toBeCloseTo(24, 9);
    expect(found.dtObserver).toBeCloseTo(-0.25, 12);
    expect(compareMarks(mark(1, 2), mark(1, 2), c).separateness).toBe('same');
  });

  it('of one thing are compared by its own clock', () => {
    const [a, b] = [coasting(ZERO, 5), coasting(ZERO, 8)];
    expect(compareMarks(seen('a', still([3, 4, 0]), a), seen('b', still([3, 4, 0]), b), c)).toMatchObject({
      dt: 3,
      dTau: 3,
      distance: 0,
      separateness: 'timelike',
    });
    const unborn = { path: '/Lamp', carriers: [{ ...still(ZERO).carriers[0]!, lifetime: { birth: 9, death: 10 } }] };
    expect(markSeen('a', unborn, a, c)).toBe('unborn');
  });
});

it('marked events are written as CSV, with quotes where names need them', () => {
  const u = properVelocity([0, 0.5, 0]);
  const [head, row] = marksCsv([markOwn('the "turn", late', coasting(u, 2))]).split('\n');
  expect(head!.split(',')).toHaveLength(11);
  expect(row).toMatch(/^"the ""turn"", late",,/);
  const [time, , y, , own, , , beta] = row!.split(',').slice(3).map(Number);
  expect(time! / (2 / Math.sqrt(0.75))).toBeCloseTo(1, 12);
  expect(y! / time!).toBeCloseTo(5, 12);
  expect([own, beta]).toEqual([2, expect.closeTo(velocity(u)[1], 12)]);
});
