import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, uniform } from '../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, IDENTITY, multiply, rotate } from '../math/quat.ts';
import { dot, length, sub, type Vec3 } from '../math/vec3.ts';
import { levelled, NOSE, noseTowards, turnFreely, turnLevel } from './turning.ts';

const Y: Vec3 = [0, 1, 0];

describe('turning with a level horizon', () => {
  it('turns about the up axis, and never beyond the zenith', () => {
    const left = rotate(turnLevel(IDENTITY, [0, Math.PI / 2, 0], Y), NOSE);
    expect(length(sub(left, [-1, 0, 0]))).toBeLessThan(1e-12);
    const high = rotate(turnLevel(IDENTITY, [10, 0, 0], Y), NOSE);
    expect(high[1]).toBeCloseTo(1, 3);
    expect(high[2]).toBeLessThan(0);
  });

  it('rolls out, and looks where it looked', () =>
    fc.assert(
      fc.property(direction, uniform(-3, 3), direction, (axis, angle, up) => {
        const ship = fromAxisAngle(axis, angle);
        fc.pre(Math.abs(dot(rotate(ship, NOSE), up)) < 0.999);
        const level = levelled(ship, up);
        expect(length(sub(rotate(level, NOSE), rotate(ship, NOSE)))).toBeLessThan(1e-12);
        expect(Math.abs(dot(rotate(level, [1, 0, 0]), up))).toBeLessThan(1e-12);
        expect(dot(rotate(level, Y), up)).toBeGreaterThan(0);
      }),
    ));

  it('rolls no faster than it may', () => {
    const rolled = fromAxisAngle([0, 0, 1], 1);
    const once = levelled(rolled, Y, 0.25);
    expect(length(sub(rotate(once, Y), rotate(fromAxisAngle([0, 0, 1], 0.75), Y)))).toBeLessThan(1e-12);
  });
});

it('turns freely about the axes of the ship: pitch, yaw and roll are about its right, its top and its tail', () => {
  const ship = fromAxisAngle([1, 2, 3], 1.1);
  for (const axis of [[1, 0, 0], Y, [0, 0, 1]] as Vec3[]) {
    const turned = turnFreely(ship, [axis[0] * 0.4, axis[1] * 0.4, axis[2] * 0.4]);
    const expected = multiply(fromAxisAngle(rotate(ship, axis), 0.4), ship);
    for (const one of [[1, 0, 0], Y, [0, 0, 1]] as Vec3[])
      expect(length(sub(rotate(turned, one), rotate(expected, one)))).toBeLessThan(1e-12);
  }
});

it('turns the nose by a share of the angle to its aim, in the plane of both', () =>
  fc.assert(
    fc.property(direction, uniform(0, 1), (aim, share) => {
      const nose = rotate(noseTowards(IDENTITY, aim, share), NOSE);
      const angle = Math.acos(Math.max(-1, Math.min(1, dot(NOSE, aim))));
      expect(Math.acos(Math.max(-1, Math.min(1, dot(nose, NOSE))))).toBeCloseTo(share * angle, 6);
      expect(Math.acos(Math.max(-1, Math.min(1, dot(nose, aim))))).toBeCloseTo((1 - share) * angle, 6);
    }),
  ));
