import { cross, distance, length, scale, type Vec3 } from '../../math/vec3.ts';
import { oneMinusBetaSquared } from '../lorentz/boost.ts';
import { cubicAt } from './cubicPiece.ts';
import { type CubicLine, cubicPiece } from './kinds/cubicLine.ts';
import type { PolylineLine } from './kinds/polylineLine.ts';
import { type SampledLine, samplePosition, samplesUntil } from './samples.ts';
import type { WorldLine } from './worldLine.ts';

type ProperTime<W> = (w: W, from: number, to: number, c: number) => number;

/** 1/γ of a velocity [m/s]; 0 from c on. */
const rateOf = (v: Vec3, c: number): number => Math.sqrt(Math.max(0, oneMinusBetaSquared(scale(v, 1 / c))));

/** Gauss–Legendre nodes ±x and their weights, 10 points on −1 … 1. Abramowitz & Stegun, table 25.4. */
const GAUSS: readonly (readonly [x: number, weight: number])[] = [
  [0.14887433898163122, 0.2955242247147529],
  [0.4333953941292472, 0.26926671930999635],
  [0.6794095682990244, 0.21908636251598204],
  [0.8650633666889845, 0.1494513491505806],
  [0.9739065285171717, 0.06667134430868814],
];

/** Of piece i between two of its times [s]. */
type PieceTime<W> = (w: W, i: number, from: number, to: number, c: number) => number;

const straightPiece: PieceTime<PolylineLine> = (w, i, from, to, c) => {
  const moved = distance(samplePosition(w, i + 1), samplePosition(w, i));
  const beta = moved / (c * (w.times[i + 1] - w.times[i]));
  return (to - from) * Math.sqrt((1 - beta) * (1 + beta));
};

const bentPiece: PieceTime<CubicLine> = (w, i, from, to, c) => {
  const piece = cubicPiece(w, i);
  const half = (to - from) / 2;
  const middle = (from + to) / 2 - w.times[i];
  const rate = (t: number) => rateOf(cubicAt(piece, t).v, c);
  return half * GAUSS.reduce((sum, [x, k]) => sum + k * (rate(middle - x * half) + rate(middle + x * half)), 0);
};

/** At rest outside the samples, piece by piece between them. */
function ofPieces<W extends SampledLine>(piece: PieceTime<W>): ProperTime<W> {
  return function properTime(w, from, to, c): number {
    if (to < from) return -properTime(w, to, from, c);
    const [first, last] = [w.times[0], w.times[w.times.length - 1]];
    let sum = Math.max(0, Math.min(to, first) - from) + Math.max(0, to - Math.max(from, last));
    const [begin, end] = [Math.max(from, first), Math.min(to, last)];
    for (let i = samplesUntil(w.times, begin) - 1; begin < end && w.times[i] < end; i++)
      sum += piece(w, i, Math.max(begin, w.times[i]), Math.min(end, w.times[i + 1]), c);
    return sum;
  };
}

/** By kind. Not in the kinds' records, which the page loads before its first picture and which need no clock. */
const PROPER_TIMES: { readonly [K in WorldLine['kind']]: ProperTime<Extract<WorldLine, { readonly kind: K }>> } = {
  static: (_, from, to) => to - from,
  uniform: (w, from, to, c) => (to - from) * rateOf(w.velocity, c),
  circular: (w, from, to, c) => (to - from) * rateOf(scale(cross(w.axis, w.arm), w.angularVelocity), c),
  hyperbolic({ properAcceleration, t0 }, from, to, c) {
    const a = length(properAcceleration);
    return a === 0 ? to - from : (c / a) * (Math.asinh((a * (to - t0)) / c) - Math.asinh((a * (from - t0)) / c));
  },
  polyline: ofPieces(straightPiece),
  cubic: ofPieces(bentPiece),
};

/**
 * Proper time ∫ √(1 − β²) dt between two world times [s]: what a clock carried along counts. Negative where to < from. c [m/s].
 * docs/physics.md §4.13.
 * @example
 * const line: WorldLine = { kind: 'uniform', position: [0, 0, 0], velocity: [8, 0, 0] };
 * properTimeBetween(line, 0, 5, 10); // 3 s
 */
export const properTimeBetween = (w: WorldLine, from: number, to: number, c: number): number =>
  (PROPER_TIMES[w.kind] as ProperTime<WorldLine>)(w, from, to, c);
