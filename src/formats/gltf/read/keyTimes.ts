import type { AnimationCurve } from './curves.ts';

/** Key times of an object's path, and those at which it jumps. */
export interface KeyTimes {
  /** [s], strictly rising. */
  readonly times: readonly number[];
  /** Ends of the ramps that replace jumps. */
  readonly jumps: ReadonlySet<number>;
}

/** Duration of the ramp that replaces a jump [s], or half the time since the previous key if shorter. */
export const JUMP_RAMP = 1e-3;
/** Union of the key times of curves, with one before each jump for a short ramp. */
export function keyTimesOf(curves: readonly AnimationCurve[]): KeyTimes {
  const keys = [...new Set(curves.flatMap((curve) => [...curve.times]))].sort((a, b) => a - b);
  const jumps = new Set(curves.flatMap((curve) => curve.jumps));
  const times: number[] = [];
  for (const [i, t] of keys.entries()) {
    const ramp = i > 0 ? Math.min(JUMP_RAMP, (t - keys[i - 1]) / 2) : JUMP_RAMP;
    // No ramp where the time is too large for f64 to resolve it.
    const before = t - ramp;
    if (jumps.has(t) && before < t && !(before <= keys[i - 1])) times.push(before);
    times.push(t);
  }
  return { times, jumps };
}
