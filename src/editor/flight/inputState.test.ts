import { afterEach, describe, expect, it, vi } from 'vitest';
import { SnapTurn } from '../../flight/comfort/snapTurn.ts';
import { InputState } from './inputState.ts';

const step = Math.PI / 4;
const dt = 1 / 60;

/** A pad of the standard mapping, whose right stick is so far to the side. */
const withStick = (x: number): void => {
  vi.stubGlobal('navigator', {
    getGamepads: () => [{ connected: true, mapping: 'standard', axes: [0, 0, x, 0], buttons: [] }],
  });
};
afterEach(() => vi.unstubAllGlobals());

function inputs(snapTurn?: SnapTurn): InputState {
  vi.stubGlobal('navigator', {});
  const input = new InputState();
  input.snapTurn = snapTurn;
  return input;
}
const yaw = (input: InputState): number => input.controls(dt).turn[1];

describe('turning', () => {
  it('is continuous: keys at 1.2 rad/s, the stick at up to twice that, drags as they are', () => {
    const input = inputs();
    input.press('ArrowLeft');
    expect(yaw(input)).toBeCloseTo(1.2 * dt, 12);
    input.release('ArrowLeft');
    input.turn(0.3, 0);
    expect(yaw(input)).toBe(0.3);
    withStick(1);
    expect(yaw(input)).toBeCloseTo(-2.4 * dt, 12);
  });

  it('in steps: by a key, by the stick of a gamepad, and by a drag of mouse or finger; looking up stays continuous', () => {
    const input = inputs(new SnapTurn(step));
    input.press('ArrowRight');
    input.press('ArrowUp');
    const { turn } = input.controls(dt);
    expect(turn[1]).toBe(-step);
    expect(turn[0]).toBeCloseTo(1.2 * dt, 12);
    input.releaseAll();
    expect(yaw(input)).toBe(0);
    withStick(-1);
    expect(yaw(input)).toBe(step);
    expect(yaw(input)).toBe(0);
    withStick(0);
    input.turn(0.6 * step, 0);
    expect(yaw(input)).toBe(0);
    input.turn(0.6 * step, 0);
    expect(yaw(input)).toBe(step);
  });
});
