import { inverseOffset, mapTime, NO_OFFSET, type TimeOffset } from '../layers/timeOffset.ts';
import type { TimeKnot } from './template.ts';

/** At a jump the first of two knots is sampled this much earlier, as in OpenUSD (UsdTimeCode::SafeStep). */
const JUMP_STEP = 2 * Number.EPSILON * 1e6 * 10;

/**
 * Maps stage times to clip times: piecewise linear, constant outside; identity without knots. At a jump the first
 * knot counts before, the second from there on.
 */
export class TimeMap {
  readonly knots: readonly TimeKnot[];
  readonly even: TimeOffset;

  constructor(knots: readonly TimeKnot[], even: TimeOffset = NO_OFFSET) {
    this.knots = [...knots].sort(([a], [b]) => a - b);
    this.even = even;
  }

  /** Stage times of knots, where samples are needed. */
  get bends(): number[] {
    return this.knots.map(([time], i) => (this.knots[i + 1]?.[0] === time ? time - JUMP_STEP : time));
  }
}

export function clipTime({ knots, even }: TimeMap, time: number): number {
  if (knots.length === 0) return mapTime(even, time);
  let low = 0;
  let high = knots.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (knots[middle][0] <= time) low = middle;
    else high = middle;
  }
  const [from, a] = knots[low];
  const next = knots[low + 1];
  if (!next || time <= from) return a;
  return a + ((next[1] - a) / (next[0] - from)) * (time - from);
}

/** Stage times in an interval at which clip times (rising) occur; up to `most`. */
export function stageTimes(
  { knots, even }: TimeMap,
  inner: Float64Array,
  [from, to]: readonly [number, number],
  most: number,
): number[] {
  if (knots.length === 0) return Array.from(inner, (time) => mapTime(inverseOffset(even), time));
  const out: number[] = [];
  for (let i = 0; i + 1 < knots.length && out.length <= most; i++) {
    const [[start, a], [end, b]] = [knots[i], knots[i + 1]];
    if (end < from || start >= to || a === b || start === end) continue;
    const [low, high] = a < b ? [a, b] : [b, a];
    for (let k = firstAtLeast(inner, low); k < inner.length && inner[k] <= high; k++)
      out.push(inner[k] === a ? start : inner[k] === b ? end : start + ((end - start) / (b - a)) * (inner[k] - a));
  }
  return out;
}

function firstAtLeast(times: Float64Array, time: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1;
    else high = middle;
  }
  return low;
}
