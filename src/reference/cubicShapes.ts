import type { Vec3 } from '../math/vec3.ts';
import { cubicAt, eased } from '../physics/cubic.ts';
import { samplesUntil } from '../physics/worldLine.ts';
import { boundingSphere } from '../scene/bounds.ts';
import { bendOf, type CubicPointsMotion, pointPiece } from '../scene/cubicPoints.ts';
import { emptyBox } from './bvh.ts';

/** How far chords may be from the cubic, as a share of the object's size: its radius in the middle of the motion. */
const CHORD = 1e-6;
/** Chords of one piece at most. */
const MOST_CHORDS = 1024;

/**
 * Cubic motion as chords that a ray can be met with: so many in each piece that no point is off its path by more than a millionth of the object's
 * size. A shape is made when it is asked for; places and velocities of single points are those of the cubic itself.
 */
export class CubicShapes {
  /** Ends of the chords [s]. */
  readonly times: Float64Array;
  private readonly motion: CubicPointsMotion;
  private readonly c: number;
  /** Of each end, the piece of the motion that begins there or holds it. */
  private readonly pieces: Int32Array;

  constructor(motion: CubicPointsMotion, c: number) {
    this.motion = motion;
    this.c = c;
    const { times, points } = motion;
    const tolerance = CHORD * boundingSphere(points[points.length >> 1]).radius;
    const [ends, pieces]: [number[], number[]] = [[], []];
    for (let k = 0; k + 1 < times.length; k++) {
      const chords = chordsOf(motion, k, bendOf(motion, k, c), tolerance);
      for (let j = 0; j < chords; j++) {
        ends.push(times[k] + (j / chords) * (times[k + 1] - times[k]));
        pieces.push(k);
      }
    }
    this.times = Float64Array.from([...ends, times[times.length - 1]]);
    this.pieces = Int32Array.from([...pieces, times.length - 1]);
  }

  /** All points at end j of the chords, from the motion's origin. */
  at(j: number): Float32Array | Float64Array {
    const { times, points, velocities } = this.motion;
    const k = this.pieces[j];
    const since = this.times[j] - times[k];
    if (since === 0) return points[k];
    const span = times[k + 1] - times[k];
    const w = since / span;
    const bend = bendOf(this.motion, k, this.c);
    const [a, b, va, vb] = [points[k], points[k + 1], velocities[k], velocities[k + 1]];
    // As hermite() of the chord and what differs from it.
    const [atBegin, atEnd] = [bend * since * (1 - w) ** 2, bend * since * w * (w - 1)];
    return Float64Array.from(a, (x, i) => {
      const moved = b[i] - x;
      const chord = moved / span;
      return x + w * moved + atBegin * (va[i] - chord) + atEnd * (vb[i] - chord);
    });
  }

  /** A box that holds all points near end j: in the pieces that it belongs to, by their control points. */
  outline(j: number, boxes: Float64Array): void {
    emptyBox(boxes, 6 * j);
    const k = this.pieces[j];
    if (k < this.motion.times.length - 1) this.grow(k, boxes, 6 * j);
    if (k > 0 && this.times[j] === this.motion.times[k]) this.grow(k - 1, boxes, 6 * j);
  }

  private grow(k: number, boxes: Float64Array, at: number): void {
    const { times, points, velocities } = this.motion;
    const third = (times[k + 1] - times[k]) / 3;
    const [a, b, va, vb] = [points[k], points[k + 1], velocities[k], velocities[k + 1]];
    for (let i = 0; i < a.length; i++) {
      const axis = i % 3;
      const [p, q] = [a[i] + third * va[i], b[i] - third * vb[i]];
      const [low, high] = [at + axis, at + 3 + axis];
      boxes[low] = Math.min(boxes[low], a[i], b[i], p, q);
      boxes[high] = Math.max(boxes[high], a[i], b[i], p, q);
    }
  }

  /** Point i at world time t between the samples, from the motion's origin, and its velocity [m/s]. */
  point(i: number, t: number): { readonly x: Vec3; readonly v: Vec3 } {
    const { motion, c } = this;
    const last = motion.times.length - 2;
    const k = Math.min(last, Math.max(0, samplesUntil(motion.times, t) - 1));
    return cubicAt(eased(pointPiece(motion, k, i), bendOf(motion, k, c)), t - motion.times[k]);
  }
}

/** The second derivative runs straight from 2(w₁ − w₀)/h to 2(w₂ − w₁)/h; a chord over s is off by s²/8 of its greatest. */
function chordsOf(
  { times, points, velocities }: CubicPointsMotion,
  k: number,
  bend: number,
  tolerance: number,
): number {
  const span = times[k + 1] - times[k];
  const [a, b, va, vb] = [points[k], points[k + 1], velocities[k], velocities[k + 1]];
  let square = 0;
  for (let i = 0; i < a.length; i += 3) {
    let [first, second] = [0, 0];
    for (let j = i; j < i + 3; j++) {
      const middle = (3 * (b[j] - a[j])) / span - va[j] - vb[j];
      first += (middle - va[j]) ** 2;
      second += (vb[j] - middle) ** 2;
    }
    square = Math.max(square, first, second);
  }
  const off = (span * bend * Math.sqrt(square)) / 4;
  return Math.min(MOST_CHORDS, Math.max(1, Math.ceil(Math.sqrt(off / tolerance))));
}
