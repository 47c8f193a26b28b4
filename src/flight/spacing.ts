import { brent } from '../math/roots.ts';

/** By which clock the pictures of a film follow each other evenly: that of the world frame, or the observer's own. */
export const FRAME_SPACINGS = ['world', 'proper'] as const;
export type FrameSpacing = (typeof FRAME_SPACINGS)[number];

/** The clock that an observer carries along his world line. World times and proper times [s]. */
export interface OwnClock {
  /** World time at which it shows that time. */
  readonly setAt: number;
  /** Proper time between two world times, `from` ≤ `to`: rising with `to`, and at most `to` − `from`. */
  elapsed(from: number, to: number): number;
}

/** Doublings of the world time in which an observer's clock is waited for; e^300 is below 2^433. */
const MAX_DOUBLINGS = 440;

/**
 * World times [s] at which an observer's clock shows the given times, which rise [s]; undefined where it never does, because he is as fast as light.
 * @example
 * // At 0.6 c a clock takes 4 s in 5 s.
 * const clock = { setAt: 0, elapsed: (from: number, to: number) => 0.8 * (to - from) };
 * worldTimesOf(clock, [0, 4, 8]); // [0, 5, 10] s
 */
export function worldTimesOf({ setAt, elapsed }: OwnClock, shown: readonly number[]): number[] | undefined {
  let [t, tau] = [setAt, setAt];
  const times: number[] = [];
  for (const next of shown) {
    const found = next < tau ? before(t, tau - next) : after(t, next - tau);
    if (found === undefined) return undefined;
    [t, tau] = [found, next];
    times.push(t);
  }
  return times;

  function after(from: number, wait: number): number | undefined {
    const late = (span: number): number => elapsed(from, from + span) - wait;
    return spanUntil(late, wait, (span) => from + span);
  }
  function before(to: number, wait: number): number | undefined {
    const late = (span: number): number => elapsed(to - span, to) - wait;
    return spanUntil(late, wait, (span) => to - span);
  }
}

/** The place of the root of `late`, which rises and is at most 0 at `least`. */
function spanUntil(late: (span: number) => number, least: number, place: (span: number) => number): number | undefined {
  if (late(least) >= 0) return place(least);
  let [lo, hi] = [least, 2 * least];
  for (let i = 0; late(hi) < 0; i++) {
    if (i === MAX_DOUBLINGS || !Number.isFinite(hi)) return undefined;
    [lo, hi] = [hi, 2 * hi];
  }
  return place(brent(late, lo, hi));
}
