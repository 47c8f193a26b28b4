import type { Vec3 } from '../../math/vec3.ts';
import { cubicAt, withBend } from '../../physics/worldLines/cubicPiece.ts';
import { samplesUntil } from '../../physics/worldLines/worldLine.ts';
import { boundingSphere } from '../../scene/bounds/bounds.ts';
import { bendFactor, type CubicPointsMotion, pointPiece } from '../../scene/motion/cubicPoints.ts';
import { emptyBox } from '../acceleration/bvh.ts';

/** How far chords may be from the cubic, as a share of the object's size: its radius in the middle of the motion. */
const CHORD_TOLERANCE = 1e-6;
/** Chords of one piece at most. */
const MAX_CHORDS = 1024;
/** A block has so many chords: trees of boxes are made for its ends only. */
const CHORDS_PER_BLOCK = 12;

/**
 * Cubic motion as chords that a ray can be met with: so many in each piece that no point is off its path by more than a millionth of the object's
 * size. Some chords together are a block: whole shapes are made for the ends of blocks, when they are asked for, and of what a ray comes near in
 * a block single triangles at the ends of chords. Places and velocities of single points are those of the cubic itself.
 */
export class CubicChords {
  /** Ends of the blocks [s]. */
  readonly times: Float64Array;
  private readonly motion: CubicPointsMotion;
  /** How much of its bend each piece keeps (`bendFactor`). */
  private readonly bends: Float64Array;
  /** Of each block, and after them of the last sample, the piece of the motion, and the place in it as a share. */
  private readonly pieces: Int32Array;
  private readonly shares: Float64Array;
  private readonly chords: Int32Array;
  private readonly chordErrors: Float64Array;

  constructor(motion: CubicPointsMotion, c: number) {
    this.motion = motion;
    const { times, points } = motion;
    this.bends = Float64Array.from({ length: times.length - 1 }, (_, k) => bendFactor(motion, k, c));
    const tolerance = CHORD_TOLERANCE * boundingSphere(points[points.length >> 1]).radius;
    const blocks: { piece: number; share: number; chords: number; bulge: number }[] = [];
    for (let piece = 0; piece + 1 < times.length; piece++) {
      const off = chordErrorOf(motion, piece, this.bends[piece]);
      const wanted = Math.min(MAX_CHORDS, Math.max(1, Math.ceil(Math.sqrt(off / tolerance))));
      const count = Math.ceil(wanted / CHORDS_PER_BLOCK);
      const chords = Math.ceil(wanted / count);
      for (let j = 0; j < count; j++) blocks.push({ piece, share: j / count, chords, bulge: off / count ** 2 });
    }
    this.pieces = Int32Array.from([...blocks.map(({ piece }) => piece), times.length - 1]);
    this.shares = Float64Array.from([...blocks.map(({ share }) => share), 0]);
    this.chords = Int32Array.from(blocks, (block) => block.chords);
    this.chordErrors = Float64Array.from(blocks, (block) => block.bulge);
    this.times = Float64Array.from(this.shares, (share, j) => this.timeAt(this.pieces[j], share));
  }

  private timeAt(piece: number, share: number): number {
    const { times } = this.motion;
    return share === 0 ? times[piece] : times[piece] + share * (times[piece + 1] - times[piece]);
  }

  /** How many chords block j has. */
  chordsIn(j: number): number {
    return this.chords[j];
  }

  /** How far points of block j are at most from where the chord of the whole block has them [m]. */
  chordErrorIn(j: number): number {
    return this.chordErrors[j];
  }

  /** All points at the beginning of block j, from the motion's origin. */
  at(j: number): Float32Array | Float64Array {
    const piece = this.pieces[j];
    if (this.shares[j] === 0) return this.motion.points[piece];
    const out = new Float64Array(this.motion.points[piece].length);
    for (let i = 0; i < out.length; i += 3) this.place(i / 3, piece, this.shares[j], out, i);
    return out;
  }

  /** Point i after so many chords of block j, from the motion's origin, to `out[to …]`. */
  chordEnd(i: number, j: number, chord: number, out: Float64Array, to: number): void {
    const next = j + 1 < this.chords.length && this.pieces[j + 1] === this.pieces[j] ? this.shares[j + 1] : 1;
    const share = this.shares[j] + (chord / this.chords[j]) * (next - this.shares[j]);
    this.place(i, this.pieces[j], chord === this.chords[j] ? next : share, out, to);
  }

  /** As hermite(): the chord, and what differs from it. At an end the sample itself. */
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

  /** A box that holds all points near the beginning of block j: in the pieces that it belongs to, by their control points. */
  outline(j: number, boxes: Float64Array): void {
    emptyBox(boxes, 6 * j);
    const k = this.pieces[j];
    if (k < this.motion.times.length - 1) this.grow(k, boxes, 6 * j);
    if (k > 0 && this.shares[j] === 0) this.grow(k - 1, boxes, 6 * j);
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
    const { motion } = this;
    const last = motion.times.length - 2;
    const k = Math.min(last, Math.max(0, samplesUntil(motion.times, t) - 1));
    return cubicAt(withBend(pointPiece(motion, k, i), this.bends[k]), t - motion.times[k]);
  }
}

/**
 * How far the chord of a whole piece is off at most [m]: the second derivative runs straight from 2(w₁ − w₀)/h to 2(w₂ − w₁)/h, and a chord over s is
 * off by s²/8 of its greatest.
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
