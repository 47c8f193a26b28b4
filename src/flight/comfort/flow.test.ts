import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AT_REST, FREELY } from '../../../tests/support/flightFixtures.ts';
import { direction, properVelocityUpTo, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { conjugate, fromAxisAngle, rotate } from '../../math/quat.ts';
import { length, sub, type Vec3 } from '../../math/vec3.ts';
import { aberrate } from '../../physics/optics/aberration.ts';
import { flyArc } from '../arc.ts';
import { properVelocityOf } from '../boost.ts';
import { type FlightState, flightOf } from '../flightState.ts';
import { pictureFlow } from './flow.ts';

const rest = flightOf(AT_REST);
const dt = 1 / 60;
const far = Number.POSITIVE_INFINITY;

describe('the flow of a picture', () => {
  it('is the rate of a turn, but none of a turn in one step', () => {
    const turned = (angle: number) => ({ ...rest, orientation: fromAxisAngle([0, 1, 0], angle) });
    const moment = { before: rest, dt, lock: 'free', distance: far } as const;
    expect(pictureFlow({ ...moment, after: turned(0.02) })).toBeCloseTo(1.2, 12);
    expect(pictureFlow({ ...moment, after: turned(Math.PI / 12) })).toBe(0);
  });

  it('is the greatest of aberration, in any direction and from any speed: the proper acceleration over c', () =>
    fc.assert(
      fc.property(properVelocityUpTo(3), direction, direction, uniform(0.01, 5), (u, push, n, size) => {
        const before = flightOf({ ...AT_REST, u });
        const after = flyArc(before, { dTau: 1e-4, push: { direction: push, size } }, FREELY);
        const flow = pictureFlow({ before, after, dt: 1e-4, lock: 'look', distance: far });
        expect(flow).toBeCloseTo(size / FREELY.c, 5);
        // Any direction of the sky is seen to move no faster, on the ship's axes, which are gyroscopes.
        const seen = ({ velocity, orientation }: FlightState): Vec3 =>
          rotate(conjugate(orientation), aberrate(n, properVelocityOf(velocity)));
        expect(length(sub(seen(after), seen(before))) / 1e-4).toBeLessThan(flow * (1 + 1e-3) + 1e-9);
      }),
    ));

  it('is v/d beside what is passed at the distance d, and at rest for the picture only that', () => {
    const before = flightOf({ ...AT_REST, u: [0, 0, -0.75] });
    const after = flyArc(before, { dTau: dt }, FREELY);
    // γβc of one's own time.
    expect(pictureFlow({ before, after, dt, lock: 'free', distance: 5 })).toBeCloseTo((0.75 * 10) / 5, 12);
    const push = { direction: [0, 0, -1] as Vec3, size: 5 };
    const pushed = flyArc(rest, { dTau: dt, push }, { ...FREELY, lock: 'fly' });
    expect(pictureFlow({ before: rest, after: pushed, dt, lock: 'fly', distance: far })).toBe(0);
  });

  it('is, for one who walks about in what is held, the rate of his turns and his way past it', () => {
    const from = { vantage: [1, 0, 0], orientation: fromAxisAngle([0, 1, 0], 2) } as const;
    const walked = (vantage: Vec3, angle: number) => ({
      before: from,
      after: { vantage, orientation: fromAxisAngle([0, 1, 0], 2 + angle) },
    });
    const moment = { before: rest, after: rest, dt, lock: 'free', distance: 5 } as const;
    // 0.5 m of 5 m.
    expect(pictureFlow({ ...moment, walked: walked([1.3, 0, 0.4], 0) })).toBeCloseTo(0.1 * 60, 12);
    expect(pictureFlow({ ...moment, walked: walked([1, 0, 0], 0.02) })).toBeCloseTo(1.2, 12);
    expect(pictureFlow({ ...moment, walked: walked([1, 0, 0], Math.PI / 12) })).toBe(0);
    const away = { ...rest, orientation: fromAxisAngle([0, 1, 0], 0.1) };
    expect(pictureFlow({ ...moment, after: away, walked: walked([1, 0, 0], 0) })).toBe(0);
  });

  it('is none while nothing moves', () => {
    expect(pictureFlow({ before: rest, after: rest, dt, lock: 'free', distance: 1 })).toBe(0);
    expect(pictureFlow({ before: rest, after: rest, dt: 0, lock: 'free', distance: 1 })).toBe(0);
  });
});
