import type { Vec3 } from '../../math/vec3.ts';

/** A point given at samples; at rest before the first and after the last one. */
export interface SampledLine {
  /** [s], strictly increasing, at least one. */
  readonly times: Float64Array;
  /** 3 per sample [m]. */
  readonly positions: Float64Array;
}

/** Sample i [m]. */
export const samplePosition = (w: SampledLine, i: number): Vec3 => [
  w.positions[3 * i],
  w.positions[3 * i + 1],
  w.positions[3 * i + 2],
];

/** The number of samples at or before t, by bisection: 0 before the first, `times.length` from the last one on. */
export const samplesUntil = (times: Float64Array, t: number): number => firstAfter(times.length, (i) => times[i] <= t);

/** By bisection, the first of `count` samples for which `before` is false, given that it is true for all samples before that one; `count` if it is always true. */
export function firstAfter(count: number, before: (sample: number) => boolean): number {
  let [lo, hi] = [0, count];
  while (lo < hi) {
    const mid = (lo + hi) >>> 1;
    if (before(mid)) lo = mid + 1;
    else hi = mid;
  }
  return lo;
}

/** Whether t is before the first sample or not before the last one, where the point is at rest. */
export const restsOutsideSamples = (w: SampledLine, t: number): boolean =>
  t < w.times[0] || t >= w.times[w.times.length - 1];
