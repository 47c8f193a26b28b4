import { describe, expect, it } from 'vitest';
import { type DeviceAngles, deviceTurn, screenOrientation } from './deviceTurn.ts';

const UPRIGHT: DeviceAngles = { alpha: 0, beta: 90, gamma: 0 };
const turn = (from: DeviceAngles, to: DeviceAngles, level: boolean, screenAngle = 0) =>
  deviceTurn(screenOrientation(from, screenAngle), screenOrientation(to, screenAngle), level).map(
    (angle) => Math.round((angle * 180e6) / Math.PI) / 1e6 + 0,
  );

describe.each([true, false])('a device that is turned; level: %s', (level) => {
  it('about the vertical, held upright: one yaws, also across north', () => {
    expect(turn(UPRIGHT, { ...UPRIGHT, alpha: 30 }, level)).toEqual([0, 30, 0]);
    expect(turn({ ...UPRIGHT, alpha: 350 }, { ...UPRIGHT, alpha: 10 }, level)).toEqual([0, 20, 0]);
  });

  it('backwards, so that its back looks up: one looks up', () => {
    expect(turn(UPRIGHT, { ...UPRIGHT, beta: 110 }, level)).toEqual([20, 0, 0]);
  });

  it('held across: the same, with the page turned on it', () => {
    // On its left side, with its back to the north: its top points to the west, and the page is turned by 90°.
    const across = (alpha: number, gamma: number): DeviceAngles => ({ alpha, beta: 0, gamma });
    expect(turn(across(90, -90), across(120, -90), level, 90)).toEqual([0, 30, 0]);
  });
});

it('looking down, a turn about the vertical is a yaw where the horizon is level, else also a roll', () => {
  const down: DeviceAngles = { ...UPRIGHT, beta: 45 };
  expect(turn(down, { ...down, alpha: 40 }, true)).toEqual([0, 40, 0]);
  const [pitch, yaw, roll] = turn(down, { ...down, alpha: 40 }, false);
  // The vertical in the screen's axes: 45° between its top and what is behind it.
  expect(pitch).toBe(0);
  expect(yaw).toBeCloseTo(40 * Math.SQRT1_2, 5);
  expect(roll).toBeCloseTo(40 * Math.SQRT1_2, 5);
});

it('flat on a table, one still looks to where it is turned', () => {
  expect(turn({ ...UPRIGHT, beta: 0 }, { ...UPRIGHT, beta: 0, alpha: 25 }, true)).toEqual([0, 25, 0]);
});
