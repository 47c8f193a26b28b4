import type { Gauge } from './look.ts';
import { POINT, SHORTEST, type Shown } from './shown.ts';

/** Edges along which the distance, or the place that the edge is graded by, changes by more than this share of the least distance are cut. */
export const GRADE = 0.75;
/** Errors of depth count this much less than those across the line of sight. */
export const DEPTH_WEIGHT = 0.25;
/** The ends that do not exist are cut off as finely as this share of an edge of the mesh. */
const HORIZON = 1 / 256;

/**
 * Into how many equal pieces an edge must be cut, so that straight pieces are off the curve that is seen by the tolerance. It depends on the points
 * of the edge alone, and not on which end comes first, to the last bit: the triangles on its two sides always agree.
 *
 * F(f) is where the point at share f of the edge is shown. Over a step h the chord is off by F″h²/8, and S = F(f − ¼) − 2F(f) + F(f + ¼) ≈ F″/16, so
 * n² = 2 max|S|/tolerance, |S| in pixels: what is across the line of sight times focal (1 + tan²θ)/|F|, θ the angle from the picture's middle.
 * Where F′ jumps by J, which shows as second differences that are not alike, by J/8 at least, the chord is off by Jh/4 at most: n = ΔS/tolerance.
 */
export class EdgeCriterion {
  private readonly gauge: Gauge;
  /** The points at ¼, ½, ¾ of the edge. */
  private readonly inner = new Float64Array(3 * POINT);
  private readonly distances = new Float64Array(5);
  private readonly magnified = new Float64Array(5);

  constructor(gauge: Gauge) {
    this.gauge = gauge;
  }

  /** 1 where it need not be cut; Infinity where it must be and it cannot be told how often. a, b: places of its ends in `points`. */
  pieces(shown: Shown, points: Float64Array, a: number, b: number): number {
    if (shown.calm(points, a, b)) return 1;
    this.sample(shown, points, a, b);
    const missing = this.missing(points, a, b);
    if (missing > 0) return missing === 5 || extent(points, a, b) <= HORIZON ? 1 : Number.POSITIVE_INFINITY;
    const least = this.measure(points, a, b);
    const length = distance(points, a, points, b, 0);
    const largest = Math.max(
      this.magnified[0],
      this.magnified[1],
      this.magnified[2],
      this.magnified[3],
      this.magnified[4],
    );
    if (length * this.gauge.look.focal * largest < SHORTEST * least) return 1;
    if (length > GRADE * least || !this.graded(points, a, b)) return Number.POSITIVE_INFINITY;
    return Math.max(1, this.curved(shown.kinked, points, a, b));
  }

  private sample(shown: Shown, points: Float64Array, a: number, b: number): void {
    const { inner } = this;
    for (let i = 0; i < 3; i++) {
      const at = POINT * i;
      // Weights are dyadic, so this is exact from both ends.
      for (let k = 6; k < POINT; k++)
        inner[at + k] = points[a + k] + (points[b + k] - points[a + k]) * (0.25 * (i + 1));
      shown.point(inner, at);
    }
  }

  /** How many of the five points do not exist. */
  private missing(points: Float64Array, a: number, b: number): number {
    let count = Number.isNaN(points[a]) ? 1 : 0;
    if (Number.isNaN(points[b])) count++;
    for (let i = 0; i < 3; i++) if (Number.isNaN(this.inner[POINT * i])) count++;
    return count;
  }

  /** Fills |F| and 1 + tan²θ, at most that of the picture's corner, of the five points; the least |F|. */
  private measure(points: Float64Array, a: number, b: number): number {
    this.measureOne(points, a, 0);
    for (let i = 0; i < 3; i++) this.measureOne(this.inner, POINT * i, i + 1);
    this.measureOne(points, b, 4);
    const r = this.distances;
    return Math.min(r[0], r[1], r[2], r[3], r[4]);
  }

  private measureOne(p: Float64Array, i: number, to: number): void {
    const [fx, fy, fz] = this.gauge.forward;
    const [x, y, z] = [p[i], p[i + 1], p[i + 2]];
    const square = x * x + y * y + z * z;
    const depth = fx * x + fy * y + fz * z;
    this.distances[to] = Math.sqrt(square);
    this.magnified[to] =
      depth > 0 && square < this.gauge.corner * depth * depth ? square / (depth * depth) : this.gauge.corner;
  }

  private graded(points: Float64Array, a: number, b: number): boolean {
    const { inner } = this;
    const least = Math.min(
      norm(points, a + 3),
      norm(inner, 3),
      norm(inner, POINT + 3),
      norm(inner, 2 * POINT + 3),
      norm(points, b + 3),
    );
    return distance(points, a, points, b, 3) <= GRADE * least;
  }

  private curved(kinked: boolean, points: Float64Array, a: number, b: number): number {
    const { inner, gauge } = this;
    const s1 = this.bendAt(points, a, 0, inner, POINT, 1);
    const s2 = this.bendAt(inner, 0, POINT, inner, 2 * POINT, 2);
    const s3 = this.bendAt(points, b, 2 * POINT, inner, POINT, 3);
    const most = Math.max(s1, s2, s3);
    const smooth = Math.sqrt((2 * most) / gauge.tolerance);
    return kinked ? Math.max(smooth, (most - Math.min(s1, s2, s3)) / gauge.tolerance) : smooth;
  }

  /** Before and after may change places. `middle`: a place in `inner`. */
  private bendAt(before: Float64Array, i: number, middle: number, after: Float64Array, k: number, at: number): number {
    const p = this.inner;
    const [x, y, z] = [p[middle], p[middle + 1], p[middle + 2]];
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
