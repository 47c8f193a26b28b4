import { MIN_EDGE_PIXELS, MIN_KINKED_EDGE_PIXELS, POINT_FLOATS, type ProjectedBody } from './projectedBody.ts';
import type { ScreenMetric } from './tessellationView.ts';

/** Edges along which the distance, or the place that the edge is graded by, changes by more than this share of the least distance are cut. */
export const MAX_GRADE = 0.75;
/**
 * The same for edges near the plane through the eye across the line of sight, where no point can be projected: no triangle reaches from there into the
 * picture, and nothing is left to the GPU's clipping, whose places SwiftShader has wrong by many pixels, or loses.
 */
export const MAX_GRADE_NEAR_CAMERA_PLANE = 0.25;
/** Cosine of the angle from the line of sight at which that begins. */
export const CAMERA_PLANE_COSINE = 0.15;
/** Errors of depth count this much less than those across the line of sight. */
export const DEPTH_WEIGHT = 0.5;
/** A quarter of an edge that is shown shorter is never cut, however far its ends are apart along the line of sight [px]. */
export const MIN_STEP_PIXELS = 0.25;
/** Ends that do not exist are cut off until what is left of an edge is shown so short [px], */
const HORIZON_STEP_PIXELS = 0.5;
/** or such a share of an edge of the mesh: near the horizon images shrink to a point. */
const HORIZON_EXTENT = 1 / 256;

export type EdgeDecision = typeof KEEP | typeof TESSELLATE | typeof SPLIT;
export const KEEP = 0;
export const TESSELLATE = 1;
export const SPLIT = 2;

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
  private readonly metric: ScreenMetric;
  /** The points at ¼, ½, ¾ of the edge. */
  private readonly inner = new Float64Array(3 * POINT_FLOATS);
  private readonly distances = new Float64Array(5);
  private readonly magnifications = new Float64Array(5);
  /** Cosines of their angles from the line of sight. */
  private readonly viewCosines = new Float64Array(5);
  /** Of the second differences of the last edge [px]. */
  private spread = 0;

  constructor(gauge: ScreenMetric) {
    this.metric = gauge;
  }

  /** 1 where it need not be cut; Infinity where it must be and it cannot be told how often. a, b: places of its ends in `points`. */
  segments(shown: ProjectedBody, points: Float64Array, a: number, b: number): number {
    if (shown.needsNoCut(points, a, b) || this.pixelLength(points, a, b) < MIN_EDGE_PIXELS) return 1;
    return this.longEdgeSegments(shown, points, a, b);
  }

  /**
   * What must be done before the levels of leaves are found, which are `most` pieces at most and do not help where an edge has a corner: CUT it;
   * LEVEL: its level does the rest; WHOLE: it has one piece.
   */
  decide(shown: ProjectedBody, points: Float64Array, a: number, b: number, most: number): EdgeDecision {
    if (shown.needsNoCut(points, a, b)) return KEEP;
    const length = this.pixelLength(points, a, b);
    if (length < (shown.kinked ? MIN_KINKED_EDGE_PIXELS : MIN_EDGE_PIXELS)) return KEEP;
    const pieces = this.longEdgeSegments(shown, points, a, b);
    if (shown.kinked && this.spread > this.metric.tolerance) return SPLIT;
    if (length < MIN_EDGE_PIXELS || pieces <= 1) return KEEP;
    return pieces > most ? SPLIT : TESSELLATE;
  }

  private longEdgeSegments(shown: ProjectedBody, points: Float64Array, a: number, b: number): number {
    this.spread = 0;
    this.sample(shown, points, a, b);
    const missing = this.countMissing(points, a, b);
    if (missing === 5) return 1;
    const step = this.longestStep(points, a, b);
    if (missing > 0)
      return step < HORIZON_STEP_PIXELS || extent(points, a, b) <= HORIZON_EXTENT ? 1 : Number.POSITIVE_INFINITY;
    if (step < MIN_STEP_PIXELS) return 1;
    if (!this.isGraded(points, a, b)) return Number.POSITIVE_INFINITY;
    return Math.max(1, Math.sqrt((2 * this.maxSecondDifference(points, a, b)) / this.metric.tolerance));
  }

  /** As it is shown [px]. By its ends alone, so that the many short edges of fine meshes cost little; NaN where one does not exist. */
  private pixelLength(points: Float64Array, a: number, b: number): number {
    this.measure(points, a, 0);
    this.measure(points, b, 4);
    const least = Math.min(this.distances[0], this.distances[4]);
    const magnified = Math.max(this.magnifications[0], this.magnifications[4]);
    return (distance(points, a, points, b, 0) * this.metric.view.focal * magnified) / least;
  }

  private sample(shown: ProjectedBody, points: Float64Array, a: number, b: number): void {
    const { inner } = this;
    for (let i = 0; i < 3; i++) {
      const at = POINT_FLOATS * i;
      // Weights are dyadic, so this is exact from both ends.
      for (let k = 6; k < POINT_FLOATS; k++)
        inner[at + k] = points[a + k] + (points[b + k] - points[a + k]) * (0.25 * (i + 1));
      shown.projectPoint(inner, at);
      this.measure(inner, at, i + 1);
    }
  }

  /** How many of the five points do not exist. */
  private countMissing(points: Float64Array, a: number, b: number): number {
    let count = Number.isNaN(points[a]) ? 1 : 0;
    if (Number.isNaN(points[b])) count++;
    for (let i = 0; i < 3; i++) if (Number.isNaN(this.inner[POINT_FLOATS * i])) count++;
    return count;
  }

  /** Fills |F|, cos θ and 1 + tan²θ, at most that of the picture's corner, of one of the five points. */
  private measure(p: Float64Array, i: number, to: number): void {
    const f = this.metric.forward;
    const x = p[i];
    const y = p[i + 1];
    const z = p[i + 2];
    const square = x * x + y * y + z * z;
    const depth = f[0] * x + f[1] * y + f[2] * z;
    const { cornerMagnification } = this.metric;
    const distance = Math.sqrt(square);
    this.distances[to] = distance;
    this.viewCosines[to] = depth / distance;
    this.magnifications[to] =
      depth > 0 && square < cornerMagnification * depth * depth ? square / (depth * depth) : cornerMagnification;
  }

  /** Of the quarters that exist, as they are shown [px]; Infinity where none does. */
  private longestStep(points: Float64Array, a: number, b: number): number {
    const { inner, magnifications: magnified } = this;
    const s1 = this.angleBetween(points, a, 0, inner, 0, 1);
    const s2 = this.angleBetween(inner, 0, 1, inner, POINT_FLOATS, 2);
    const s3 = this.angleBetween(inner, POINT_FLOATS, 2, inner, 2 * POINT_FLOATS, 3);
    const s4 = this.angleBetween(inner, 2 * POINT_FLOATS, 3, points, b, 4);
    const turned = Math.max(s1, s2, s3, s4);
    if (turned < 0) return Number.POSITIVE_INFINITY;
    let most = 1;
    for (let k = 0; k < 5; k++) if (magnified[k] > most) most = magnified[k];
    return turned * this.metric.view.focal * most;
  }

  /** Between the directions of two points [rad], less than 0 where one does not exist; `from`, `to`: which of the five they are. */
  private angleBetween(p: Float64Array, i: number, from: number, q: Float64Array, k: number, to: number): number {
    const near = this.distances[from];
    const far = this.distances[to];
    const x = p[i] / near - q[k] / far;
    const y = p[i + 1] / near - q[k + 1] / far;
    const z = p[i + 2] / near - q[k + 2] / far;
    const square = x * x + y * y + z * z;
    return square >= 0 ? Math.sqrt(square) : -1;
  }

  /** Both of where it is shown and of what it is graded by. */
  private isGraded(points: Float64Array, a: number, b: number): boolean {
    const { inner, distances: r } = this;
    const grade = this.isNearCameraPlane() ? MAX_GRADE_NEAR_CAMERA_PLANE : MAX_GRADE;
    if (distance(points, a, points, b, 0) > grade * Math.min(r[0], r[1], r[2], r[3], r[4])) return false;
    const ends = Math.min(norm(points, a + 3), norm(points, b + 3));
    const least = Math.min(ends, norm(inner, 3), norm(inner, POINT_FLOATS + 3), norm(inner, 2 * POINT_FLOATS + 3));
    return distance(points, a, points, b, 3) <= MAX_GRADE * least;
  }

  private isNearCameraPlane(): boolean {
    const { viewCosines: c } = this;
    return (
      Math.min(c[0], c[1], c[2], c[3], c[4]) < CAMERA_PLANE_COSINE &&
      Math.max(c[0], c[1], c[2], c[3], c[4]) > -CAMERA_PLANE_COSINE
    );
  }

  /** The largest second difference [px]; their spread is left in `spread`. */
  private maxSecondDifference(points: Float64Array, a: number, b: number): number {
    const { inner } = this;
    const s1 = this.secondDifferenceAt(points, a, 0, inner, POINT_FLOATS, 1);
    const s2 = this.secondDifferenceAt(inner, 0, POINT_FLOATS, inner, 2 * POINT_FLOATS, 2);
    const s3 = this.secondDifferenceAt(points, b, 2 * POINT_FLOATS, inner, POINT_FLOATS, 3);
    const most = Math.max(s1, s2, s3);
    this.spread = most - Math.min(s1, s2, s3);
    return most;
  }

  /** Before and after may change places. `middle`: a place in `inner`. */
  private secondDifferenceAt(
    before: Float64Array,
    i: number,
    middle: number,
    after: Float64Array,
    k: number,
    at: number,
  ): number {
    const p = this.inner;
    const x = p[middle];
    const y = p[middle + 1];
    const z = p[middle + 2];
    const sx = before[i] + after[k] - 2 * x;
    const sy = before[i + 1] + after[k + 1] - 2 * y;
    const sz = before[i + 2] + after[k + 2] - 2 * z;
    const r = this.distances[at];
    const along = (sx * x + sy * y + sz * z) / r;
    const across = Math.sqrt(Math.max(0, sx * sx + sy * sy + sz * sz - along * along)) * this.magnifications[at];
    const depth = DEPTH_WEIGHT * along;
    return (this.metric.view.focal / r) * Math.sqrt(across * across + depth * depth);
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
