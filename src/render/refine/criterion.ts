import type { Gauge } from './look.ts';
import { POINT, SHORTEST, SHORTEST_KINKED, type Shown } from './shown.ts';

/** Edges along which the distance, or the place that the edge is graded by, changes by more than this share of the least distance are cut. */
export const GRADE = 0.75;
/**
 * The same for edges near the plane through the eye across the line of sight, where no point can be projected: no triangle reaches from there into the
 * picture, and nothing is left to the GPU's clipping, whose places SwiftShader has wrong by many pixels, or loses.
 */
export const GRADE_SIDEWAYS = 0.25;
/** Cosine of the angle from the line of sight at which that begins. */
export const SIDEWAYS = 0.15;
/** Errors of depth count this much less than those across the line of sight. */
export const DEPTH_WEIGHT = 0.5;
/** A quarter of an edge that is shown shorter is never cut, however far its ends are apart along the line of sight [px]. */
export const SHORTEST_STEP = 0.25;
/** Ends that do not exist are cut off until what is left of an edge is shown so short [px], */
const HORIZON_STEP = 0.5;
/** or such a share of an edge of the mesh: near the horizon images shrink to a point. */
const HORIZON = 1 / 256;

export type Verdict = typeof WHOLE | typeof LEVEL | typeof CUT;
export const WHOLE = 0;
export const LEVEL = 1;
export const CUT = 2;

/**
 * Into how many equal pieces an edge must be cut, so that straight pieces are off the curve that is seen by the tolerance. It depends on the points
 * of the edge alone, and not on which end comes first, to the last bit: the triangles on its two sides always agree.
 *
 * F(f) is where the point at share f of the edge is shown. Over a step h the chord is off by F″h²/8, and S = F(f − ¼) − 2F(f) + F(f + ¼) ≈ F″/16, so
 * n² = 2 max|S|/tolerance, |S| in pixels: what is across the line of sight times focal (1 + tan²θ)/|F|, θ the angle from the picture's middle.
 * Where F′ jumps by J, as it does where velocities change suddenly, second differences are not alike: their spread is J/8 at least, but near the ends, and
 * the chord is off by J/4 at most.
 */
export class EdgeCriterion {
  private readonly gauge: Gauge;
  /** The points at ¼, ½, ¾ of the edge. */
  private readonly inner = new Float64Array(3 * POINT);
  private readonly distances = new Float64Array(5);
  private readonly magnified = new Float64Array(5);
  /** Cosines of their angles from the line of sight. */
  private readonly ahead = new Float64Array(5);
  /** Of the second differences of the last edge [px]. */
  private spread = 0;

  constructor(gauge: Gauge) {
    this.gauge = gauge;
  }

  /** 1 where it need not be cut; Infinity where it must be and it cannot be told how often. a, b: places of its ends in `points`. */
  pieces(shown: Shown, points: Float64Array, a: number, b: number): number {
    if (shown.calm(points, a, b) || this.length(points, a, b) < SHORTEST) return 1;
    return this.longPieces(shown, points, a, b);
  }

  /**
   * What must be done before the levels of leaves are found, which are `most` pieces at most and do not help where an edge has a corner: CUT it;
   * LEVEL: its level does the rest; WHOLE: it has one piece.
   */
  verdict(shown: Shown, points: Float64Array, a: number, b: number, most: number): Verdict {
    if (shown.calm(points, a, b)) return WHOLE;
    const length = this.length(points, a, b);
    if (length < (shown.kinked ? SHORTEST_KINKED : SHORTEST)) return WHOLE;
    const pieces = this.longPieces(shown, points, a, b);
    if (shown.kinked && this.spread > this.gauge.tolerance) return CUT;
    if (length < SHORTEST || pieces <= 1) return WHOLE;
    return pieces > most ? CUT : LEVEL;
  }

  private longPieces(shown: Shown, points: Float64Array, a: number, b: number): number {
    this.spread = 0;
    this.sample(shown, points, a, b);
    const missing = this.missing(points, a, b);
    if (missing === 5) return 1;
    const step = this.longestStep(points, a, b);
    if (missing > 0) return step < HORIZON_STEP || extent(points, a, b) <= HORIZON ? 1 : Number.POSITIVE_INFINITY;
    if (step < SHORTEST_STEP) return 1;
    if (!this.graded(points, a, b)) return Number.POSITIVE_INFINITY;
    return Math.max(1, Math.sqrt((2 * this.bend(points, a, b)) / this.gauge.tolerance));
  }

  /** As it is shown [px]. By its ends alone, so that the many short edges of fine meshes cost little; NaN where one does not exist. */
  private length(points: Float64Array, a: number, b: number): number {
    this.measure(points, a, 0);
    this.measure(points, b, 4);
    const least = Math.min(this.distances[0], this.distances[4]);
    const magnified = Math.max(this.magnified[0], this.magnified[4]);
    return (distance(points, a, points, b, 0) * this.gauge.look.focal * magnified) / least;
  }

  private sample(shown: Shown, points: Float64Array, a: number, b: number): void {
    const { inner } = this;
    for (let i = 0; i < 3; i++) {
      const at = POINT * i;
      // Weights are dyadic, so this is exact from both ends.
      for (let k = 6; k < POINT; k++)
        inner[at + k] = points[a + k] + (points[b + k] - points[a + k]) * (0.25 * (i + 1));
      shown.point(inner, at);
      this.measure(inner, at, i + 1);
    }
  }

  /** How many of the five points do not exist. */
  private missing(points: Float64Array, a: number, b: number): number {
    let count = Number.isNaN(points[a]) ? 1 : 0;
    if (Number.isNaN(points[b])) count++;
    for (let i = 0; i < 3; i++) if (Number.isNaN(this.inner[POINT * i])) count++;
    return count;
  }

  /** Fills |F|, cos θ and 1 + tan²θ, at most that of the picture's corner, of one of the five points. */
  private measure(p: Float64Array, i: number, to: number): void {
    const f = this.gauge.forward;
    const x = p[i];
    const y = p[i + 1];
    const z = p[i + 2];
    const square = x * x + y * y + z * z;
    const depth = f[0] * x + f[1] * y + f[2] * z;
    const { corner } = this.gauge;
    const distance = Math.sqrt(square);
    this.distances[to] = distance;
    this.ahead[to] = depth / distance;
    this.magnified[to] = depth > 0 && square < corner * depth * depth ? square / (depth * depth) : corner;
  }

  /** Of the quarters that exist, as they are shown [px]; Infinity where none does. */
  private longestStep(points: Float64Array, a: number, b: number): number {
    const { inner, magnified } = this;
    const s1 = this.turn(points, a, 0, inner, 0, 1);
    const s2 = this.turn(inner, 0, 1, inner, POINT, 2);
    const s3 = this.turn(inner, POINT, 2, inner, 2 * POINT, 3);
    const s4 = this.turn(inner, 2 * POINT, 3, points, b, 4);
    const turned = Math.max(s1, s2, s3, s4);
    if (turned < 0) return Number.POSITIVE_INFINITY;
    let most = 1;
    for (let k = 0; k < 5; k++) if (magnified[k] > most) most = magnified[k];
    return turned * this.gauge.look.focal * most;
  }

  /** Between the directions of two points [rad], less than 0 where one does not exist; `from`, `to`: which of the five they are. */
  private turn(p: Float64Array, i: number, from: number, q: Float64Array, k: number, to: number): number {
    const near = this.distances[from];
    const far = this.distances[to];
    const x = p[i] / near - q[k] / far;
    const y = p[i + 1] / near - q[k + 1] / far;
    const z = p[i + 2] / near - q[k + 2] / far;
    const square = x * x + y * y + z * z;
    return square >= 0 ? Math.sqrt(square) : -1;
  }

  /** Both of where it is shown and of what it is graded by. */
  private graded(points: Float64Array, a: number, b: number): boolean {
    const { inner, distances: r } = this;
    const grade = this.sideways() ? GRADE_SIDEWAYS : GRADE;
    if (distance(points, a, points, b, 0) > grade * Math.min(r[0], r[1], r[2], r[3], r[4])) return false;
    const ends = Math.min(norm(points, a + 3), norm(points, b + 3));
    const least = Math.min(ends, norm(inner, 3), norm(inner, POINT + 3), norm(inner, 2 * POINT + 3));
    return distance(points, a, points, b, 3) <= GRADE * least;
  }

  private sideways(): boolean {
    const { ahead: c } = this;
    return Math.min(c[0], c[1], c[2], c[3], c[4]) < SIDEWAYS && Math.max(c[0], c[1], c[2], c[3], c[4]) > -SIDEWAYS;
  }

  /** The largest second difference [px]; their spread is left in `spread`. */
  private bend(points: Float64Array, a: number, b: number): number {
    const { inner } = this;
    const s1 = this.bendAt(points, a, 0, inner, POINT, 1);
    const s2 = this.bendAt(inner, 0, POINT, inner, 2 * POINT, 2);
    const s3 = this.bendAt(points, b, 2 * POINT, inner, POINT, 3);
    const most = Math.max(s1, s2, s3);
    this.spread = most - Math.min(s1, s2, s3);
    return most;
  }

  /** Before and after may change places. `middle`: a place in `inner`. */
  private bendAt(before: Float64Array, i: number, middle: number, after: Float64Array, k: number, at: number): number {
    const p = this.inner;
    const x = p[middle];
    const y = p[middle + 1];
    const z = p[middle + 2];
    const sx = before[i] + after[k] - 2 * x;
    const sy = before[i + 1] + after[k + 1] - 2 * y;
    const sz = before[i + 2] + after[k + 2] - 2 * z;
    const r = this.distances[at];
    const along = (sx * x + sy * y + sz * z) / r;
    const across = Math.sqrt(Math.max(0, sx * sx + sy * sy + sz * sz - along * along)) * this.magnified[at];
    const depth = DEPTH_WEIGHT * along;
    return (this.gauge.look.focal / r) * Math.sqrt(across * across + depth * depth);
  }
}

/** Share of the longest edge of the mesh's triangle that an edge is. */
function extent(points: Float64Array, a: number, b: number): number {
  const d1 = points[a + 6] - points[b + 6];
  const d2 = points[a + 7] - points[b + 7];
  return Math.max(Math.abs(d1), Math.abs(d2), Math.abs(d1 + d2));
}

const norm = (p: Float64Array, i: number): number => Math.sqrt(p[i] * p[i] + p[i + 1] * p[i + 1] + p[i + 2] * p[i + 2]);

function distance(p: Float64Array, i: number, q: Float64Array, k: number, from: number): number {
  const x = p[i + from] - q[k + from];
  const y = p[i + from + 1] - q[k + from + 1];
  const z = p[i + from + 2] - q[k + from + 2];
  return Math.sqrt(x * x + y * y + z * z);
}
