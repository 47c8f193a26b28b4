import { describe, expect, it } from 'vitest';
import { TouchGestures } from './gestures.ts';

const NOTHING = { drag: [0, 0], spread: 1, twist: 0 };

/** Two fingers, 100 px apart. */
function twoDown(): TouchGestures {
  const gestures = new TouchGestures();
  gestures.down(1, 0, 0);
  gestures.down(2, 100, 0);
  return gestures;
}

describe('one finger', () => {
  it('drags, from where it has clearly moved on', () => {
    const gestures = new TouchGestures();
    expect(gestures.move(1, 5, 5)).toEqual(NOTHING);
    gestures.down(1, 10, 20);
    expect(gestures.move(1, 13, 18)).toEqual(NOTHING);
    expect(gestures.move(1, 40, 18)).toEqual(NOTHING);
    expect(gestures.move(1, 43, 16)).toEqual({ ...NOTHING, drag: [3, -2] });
    expect(gestures.up(1)).toBeUndefined();
  });

  it('taps where it hardly moves', () => {
    const gestures = new TouchGestures();
    gestures.down(1, 10, 20);
    gestures.move(1, 12, 21);
    expect(gestures.up(1)).toEqual([12, 21]);
    expect(gestures.up(1)).toBeUndefined();
  });

  it('rests once, and then does not tap', () => {
    const gestures = new TouchGestures();
    expect(gestures.takeRest()).toBeUndefined();
    gestures.down(1, 10, 20);
    expect(gestures.takeRest()).toEqual([10, 20]);
    expect(gestures.takeRest()).toBeUndefined();
    expect(gestures.up(1)).toBeUndefined();
  });
});

describe('two fingers', () => {
  it('spread by the ratio of their distances, without the little that anyone moves', () => {
    const gestures = twoDown();
    expect(gestures.move(2, 110, 0)).toEqual(NOTHING);
    expect(gestures.move(2, 120, 0)).toEqual(NOTHING);
    expect(gestures.move(2, 240, 0)).toEqual({ ...NOTHING, spread: 2 });
    expect(gestures.move(2, 60, 0)).toEqual({ ...NOTHING, spread: 0.25 });
  });

  it('twist, anticlockwise being positive on a screen whose y is down', () => {
    const gestures = twoDown();
    const at = (angle: number) => gestures.move(2, 100 * Math.cos(angle), -100 * Math.sin(angle));
    expect(at(0.1).twist).toBe(0);
    expect(at(0.2).twist).toBe(0);
    const { twist, spread } = at(0.5);
    expect(twist).toBeCloseTo(0.3, 12);
    expect(spread).toBe(1);
    // Half a turn is crossed without a jump.
    let sum = 0;
    for (let tenths = 6; tenths <= 60; tenths++) sum += at(tenths / 10).twist;
    expect(sum).toBeCloseTo(5.5, 9);
  });

  it('neither tap nor rest, and the one that is left drags', () => {
    const gestures = twoDown();
    expect(gestures.takeRest()).toBeUndefined();
    expect(gestures.up(2)).toBeUndefined();
    expect(gestures.move(1, 3, 4)).toEqual({ ...NOTHING, drag: [3, 4] });
    expect(gestures.up(1)).toBeUndefined();
  });
});

it('three do nothing', () => {
  const gestures = twoDown();
  gestures.down(3, 50, 50);
  expect(gestures.move(3, 500, 500)).toEqual(NOTHING);
  expect(gestures.up(3)).toBeUndefined();
});
