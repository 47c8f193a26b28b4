import type { Vec3 } from '../../../math/vec3.ts';
import { cubicAt, withBend } from '../../../physics/worldLines/cubicPiece.ts';
import { samplesUntil } from '../../../physics/worldLines/samples.ts';
import { boundingSphere } from '../../../scene/bounds/bounds.ts';
import { bendFactor, type CubicPointsMotion, pointPiece } from '../../../scene/motion/cubicPoints.ts';
import { emptyBox } from '../../acceleration/bvh.ts';

/** Greatest distance of chords from the cubic, as a fraction of the object's size: its radius at the middle sample. */
const CHORD_TOLERANCE = 1e-6;
/** Upper bound of the number of chords per piece. */
const MAX_CHORDS = 1024;
/** Upper bound of the number of chords per block; BVHs are refitted at the ends of blocks only. */
const CHORDS_PER_BLOCK = 12;

/**
 * Cubic motion as chords, for intersection with rays: each piece has so many that no point is off its path by more than a millionth of the
 * object's size. Consecutive chords form a block: the whole shape is evaluated at the ends of blocks only, lazily, and in between only the
 * triangles near a ray, at the ends of chords. Positions and velocities of single points (`point`) are those of the cubic itself.
 */
export class CubicChords {
  /** Ends of the blocks [s]. */
  readonly times: Float64Array;
  private readonly motion: CubicPointsMotion;
  /** `bendFactor` of each piece. */
  private readonly bends: Float64Array;
  /** Piece of the motion in which each block begins, and the fraction of the piece before it; one more entry for the last sample. */
  private readonly pieces: Int32Array;
  private readonly fractions: Float64Array;
  private readonly chords: Int32Array;
  private readonly chordErrors: Float64Array;

  constructor(motion: CubicPointsMotion, c: number) {
    this.motion = motion;
    const { times, points } = motion;
    this.bends = Float64Array.from({ length: times.length - 1 }, (_, k) => bendFactor(motion, k, c));
    const tolerance = CHORD_TOLERANCE * boundingSphere(points[points.length >> 1]).radius;
    const blocks: { piece: number; fraction: number; chords: number; bulge: number }[] = [];
    for (let piece = 0; piece + 1 < times.length; piece++) {
      const error = chordErrorOf(motion, piece, this.bends[piece]);
      const chordsNeeded = Math.min(MAX_CHORDS, Math.max(1, Math.ceil(Math.sqrt(error / tolerance))));
      const count = Math.ceil(chordsNeeded / CHORDS_PER_BLOCK);
      const chords = Math.ceil(chordsNeeded / count);
      for (let j = 0; j < count; j++) blocks.push({ piece, fraction: j / count, chords, bulge: error / count ** 2 });
    }
    this.pieces = Int32Array.from([...blocks.map(({ piece }) => piece), times.length - 1]);
    this.fractions = Float64Array.from([...blocks.map(({ fraction }) => fraction), 0]);
    this.chords = Int32Array.from(blocks, (block) => block.chords);
    this.chordErrors = Float64Array.from(blocks, (block) => block.bulge);
    this.times = Float64Array.from(this.fractions, (fraction, j) => this.timeAt(this.pieces[j], fraction));
  }

  private timeAt(piece: number, fraction: number): number {
    const { times } = this.motion;
    return fraction === 0 ? times[piece] : times[piece] + fraction * (times[piece + 1] - times[piece]);
  }

  /** Number of chords of block j. */
  chordsIn(j: number): number {
    return this.chords[j];
  }

  /** Upper bound of the distance of points of block j from the chord over the whole block [m]. */
  chordErrorIn(j: number): number {
    return this.chordErrors[j];
  }

  /** All points at the beginning of block j, relative to the motion's origin. */
  at(j: number): Float32Array | Float64Array {
    const piece = this.pieces[j];
    if (this.fractions[j] === 0) return this.motion.points[piece];
    const out = new Float64Array(this.motion.points[piece].length);
    for (let i = 0; i < out.length; i += 3) this.place(i / 3, piece, this.fractions[j], out, i);
    return out;
  }

  /** Writes point i at the beginning of chord number `chord` of block j to `out[to …]`, relative to the motion's origin. */
  chordEnd(i: number, j: number, chord: number, out: Float64Array, to: number): void {
    const next = j + 1 < this.chords.length && this.pieces[j + 1] === this.pieces[j] ? this.fractions[j + 1] : 1;
    const fraction = this.fractions[j] + (chord / this.chords[j]) * (next - this.fractions[j]);
    this.place(i, this.pieces[j], chord === this.chords[j] ? next : fraction, out, to);
  }

  /** The cubic in Hermite form, as the chord plus the deviation from it (docs/physics.md §4.8); exactly the sample at both ends. */
  private place(i: number, piece: number, w: number, out: Float64Array, to: number): void {
    const { times, points, velocities } = this.motion;
    const [a, b, va, vb] = [points[piece], points[piece + 1], velocities[piece], velocities[piece + 1]];
    const span = times[piece + 1] - times[piece];
    const since = this.bends[piece] * span * w * (1 - w);
    for (let axis = 0; axis < 3; axis++) {
      const at = 3 * i + axis;
      const moved = b[at] - a[at];
      const chord = moved / span;
      const straight = w === 1 ? b[at] : a[at] + w * moved;
      out[to + axis] = straight + since * ((1 - w) * (va[at] - chord) - w * (vb[at] - chord));
    }
  }

  /** Writes a box that contains the control points of each piece that the beginning of block j belongs to. */
  outline(j: number, boxes: Float64Array): void {
    emptyBox(boxes, 6 * j);
    const k = this.pieces[j];
    if (k < this.motion.times.length - 1) this.grow(k, boxes, 6 * j);
    if (k > 0 && this.fractions[j] === 0) this.grow(k - 1, boxes, 6 * j);
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

  /** Point i at world time t between the samples, relative to the motion's origin, and its velocity [m/s]. */
  point(i: number, t: number): { readonly x: Vec3; readonly v: Vec3 } {
    const { motion } = this;
    const last = motion.times.length - 2;
    const k = Math.min(last, Math.max(0, samplesUntil(motion.times, t) - 1));
    return cubicAt(withBend(pointPiece(motion, k, i), this.bends[k]), t - motion.times[k]);
  }
}

/**
 * Upper bound of the error of one chord over a whole piece [m]: the second derivative is linear between 2(w₁ − w₀)/h and 2(w₂ − w₁)/h, and a chord over
 * s is off by at most s²/8 of its greatest value. docs/physics.md §9.3.
 */
function chordErrorOf({ times, points, velocities }: CubicPointsMotion, k: number, bend: number): number {
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
  return (span * bend * Math.sqrt(square)) / 4;
}
