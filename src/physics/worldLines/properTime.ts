import { length, scale } from '../../math/vec3.ts';
import { oneMinusBetaSquared } from '../lorentz/boost.ts';
import { samplesUntil } from './samples.ts';
import { velocityAt, type WorldLine } from './worldLine.ts';

type Elapsed<W extends WorldLine> = (line: W, from: number, to: number, c: number) => number;

/** √(1 − β²); 0 where β exceeds 1. */
const slowness = (line: WorldLine, t: number, c: number): number =>
  Math.sqrt(Math.max(0, oneMinusBetaSquared(scale(velocityAt(line, t, c), 1 / c))));

/** At constant speed. */
const steady: Elapsed<WorldLine> = (line, from, to, c) => (to - from) * slowness(line, from, c);

/** Intervals of Simpson's rule in a cubic piece, even. */
const INTERVALS = 32;

/** At varying speed. The last velocity is taken a little before the end, where the next piece begins. */
function integrated(line: WorldLine, from: number, to: number, c: number): number {
  const step = (to - from) / INTERVALS;
  let sum = 0;
  for (let k = 0; k <= INTERVALS; k++) {
    const weight = k === 0 || k === INTERVALS ? 1 : 2 + 2 * (k % 2);
    const t = k === INTERVALS ? to - 1e-9 * (to - from) : from + k * step;
    sum += weight * slowness(line, t, c);
  }
  return (sum * step) / 3;
}

/** Piece by piece, from sample to sample. */
const sampled =
  <W extends WorldLine & { readonly times: Float64Array }>(piece: Elapsed<WorldLine>): Elapsed<W> =>
  (line, from, to, c) => {
    const { times } = line;
    const cuts = [from, ...times.subarray(samplesUntil(times, from), samplesUntil(times, to)), to];
    return cuts.slice(1).reduce((sum, end, k) => sum + piece(line, cuts[k], end, c), 0);
  };

const ELAPSED: { readonly [K in WorldLine['kind']]: Elapsed<Extract<WorldLine, { readonly kind: K }>> } = {
  static: (_line, from, to) => to - from,
  uniform: steady,
  circular: steady,
  // τ = (c/a) asinh(at/c)
  hyperbolic(line, from, to, c) {
    const a = length(line.properAcceleration);
    const clock = (t: number): number => (a === 0 ? t : (c / a) * Math.asinh((a / c) * (t - line.t0)));
    return clock(to) - clock(from);
  },
  polyline: sampled(steady),
  cubic: sampled(integrated),
};

/**
 * Proper time ∫ √(1 − β²) dt [s] along a world line between two world times [s] of the world frame; c [m/s]. Negative if `to` is the earlier one.
 * @example
 * const line: WorldLine = { kind: 'uniform', position: [0, 0, 0], velocity: [6, 0, 0] };
 * properTimeBetween(line, 0, 5, 10); // 4 s
 */
export function properTimeBetween(line: WorldLine, from: number, to: number, c: number): number {
  if (to < from) return -properTimeBetween(line, to, from, c);
  return (ELAPSED[line.kind] as Elapsed<WorldLine>)(line, from, to, c);
}
