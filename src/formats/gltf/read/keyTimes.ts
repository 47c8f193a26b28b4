import type { AnimationCurve } from './curves.ts';

/** Times between which an object's path is drawn straight, and those of them at which it may not be refined. */
export interface KeyTimes {
  /** [s], strictly rising. */
  readonly times: readonly number[];
  /** Ends of the short ramps that stand for jumps. */
  readonly jumps: ReadonlySet<number>;
}

/** A jump becomes a ramp of this length [s], or half the time since the key before, where that is shorter. */
export const JUMP_RAMP = 1e-3;
/** All key times of some curves; before each jump there is one more, so that the jump is a short ramp. */
export function keyTimesOf(curves: readonly AnimationCurve[]): KeyTimes {
  const keys = [...new Set(curves.flatMap((curve) => [...curve.times]))].sort((a, b) => a - b);
  const jumps = new Set(curves.flatMap((curve) => curve.jumps));
  const times: number[] = [];
  for (const [i, t] of keys.entries()) {
    const ramp = i > 0 ? Math.min(JUMP_RAMP, (t - keys[i - 1]) / 2) : JUMP_RAMP;
    // Of a time that is too large for a ramp before it nothing is made.
    const before = t - ramp;
    if (jumps.has(t) && before < t && !(before <= keys[i - 1])) times.push(before);
    times.push(t);
  }
  return { times, jumps };
}
