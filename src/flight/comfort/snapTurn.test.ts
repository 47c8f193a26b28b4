import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { SnapTurn } from './snapTurn.ts';

const step = Math.PI / 6;
const held = (turn: SnapTurn, side: number, seconds: number): number => {
  let yaw = 0;
  for (let i = 0; i < seconds * 60; i++) yaw += turn.yaw({ dragged: 0, held: side }, 1 / 60);
  return yaw / step;
};

describe('turning in steps', () => {
  it('a key turns once at once, again every half second while it is held, and once more when it is pressed again', () => {
    const turn = new SnapTurn(step);
    expect(turn.yaw({ dragged: 0, held: 1 }, 1 / 60)).toBe(step);
    expect(held(turn, 1, 0.4)).toBe(0);
    expect(held(turn, 1, 1)).toBeCloseTo(2, 12);
    expect(held(turn, 0, 0.05)).toBe(0);
    expect(held(turn, 1, 0.1)).toBe(1);
    expect(turn.yaw({ dragged: 0, held: -1 }, 1 / 60)).toBe(-step);
  });

  it('a stick turns when it is far enough to the side, and not again before it is let go', () => {
    const turn = new SnapTurn(step);
    expect(held(turn, -0.7, 0.1)).toBe(0);
    expect(held(turn, -1.9, 0.1)).toBe(-1);
    expect(held(turn, -0.7, 0.1)).toBe(0);
    expect(held(turn, -1.9, 0.1)).toBe(0);
    expect(held(turn, 0, 0.1)).toBe(0);
    expect(held(turn, -1.9, 0.1)).toBe(-1);
  });

  it('a drag turns by the steps that it is long, whatever its pieces', () =>
    fc.assert(
      fc.property(fc.array(fc.double({ min: -0.4, max: 0.4, noNaN: true }), { maxLength: 40 }), (pieces) => {
        const turn = new SnapTurn(step);
        let [way, yaw] = [0, 0];
        for (const dragged of pieces) {
          way += dragged;
          yaw += turn.yaw({ dragged, held: 0 }, 1 / 60);
          expect(Math.abs(yaw / step - Math.round(yaw / step))).toBeLessThan(1e-9);
          // Less than a step is left.
          expect(Math.abs(way - yaw)).toBeLessThan(step * (1 + 1e-9));
        }
      }),
    ));

  it('what is left of a drag is forgotten when it rests', () => {
    const turn = new SnapTurn(step);
    expect(turn.yaw({ dragged: 0.9 * step, held: 0 }, 1 / 60)).toBe(0);
    expect(held(turn, 0, 0.6)).toBe(0);
    expect(turn.yaw({ dragged: 0.2 * step, held: 0 }, 1 / 60)).toBe(0);
  });
});
