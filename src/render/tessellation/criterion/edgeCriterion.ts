import {
  MIN_EDGE_PIXELS,
  MIN_KINKED_EDGE_PIXELS,
  MIN_ROUND_EDGE_PIXELS,
  POINT_FLOATS,
  type ProjectedBody,
  ROUND_STRICTNESS,
} from './projectedBody.ts';
import type { ScreenMetric } from './tessellationView.ts';

/** Edges along which the distance, or the place that the edge is graded by, changes by more than this fraction of the least distance are split. */
export const MAX_GRADE = 0.75;
/**
 * The same near the plane through the observer across the line of sight, where nothing can be projected. Triangles that cross it would be clipped by the GPU,
 * and SwiftShader misplaces clipped vertices by many pixels, or loses them; split finely enough, no triangle reaches from that plane into the picture.
 */
export const MAX_GRADE_NEAR_CAMERA_PLANE = 0.25;
/** Cosine of the angle from the line of sight at which that begins. */
export const CAMERA_PLANE_COSINE = 0.15;
/** Weight of errors in depth against those across the line of sight: inside triangles, which sag up to twice as far as their edges, depth is still within a pixel. */
export const DEPTH_WEIGHT = 0.6;
/** An edge whose quarters all appear shorter than this is never split, however far apart its ends are along the line of sight [px]. */
export const MIN_STEP_PIXELS = 0.25;
/** Edges with ends that do not exist are split until what is left appears shorter than this [px], … */
const HORIZON_STEP_PIXELS = 0.5;
/** … or is at most this fraction of an edge of the mesh: near the horizon images shrink to a point. */
const HORIZON_EXTENT = 1 / 256;

export type EdgeDecision = typeof KEEP | typeof TESSELLATE | typeof SPLIT;
export const KEEP = 0;
export const TESSELLATE = 1;
export const SPLIT = 2;

/**
 * The number of equal segments that an edge needs so that straight segments stay within the tolerance of the curve that is seen (docs/physics.md §9.1). It
 * depends on the points of the edge alone, and to the last bit not on their order, so the triangles on both sides always agree.
 * F(f) is the observer position of the point at fraction f of the edge. Over a step h the chord is off by F″h²/8, and S = F(f − ¼) − 2F(f) + F(f + ¼) ≈
 * F″/16, so n² = 2 max|S|/tolerance, with |S| in pixels: the part across the line of sight, times focal (1 + tan²θ)/|F|, θ the angle from the picture's
 * centre. Where F′ jumps by J, as it does where velocities change suddenly, the second differences differ: their spread is at least J/8 except near the ends,
 * and the chord is off by at most J/4.
 */
export class EdgeCriterion {
  private readonly metric: ScreenMetric;
  /** The points at ¼, ½, ¾ of the edge. */
  private readonly inner = new Float64Array(3 * POINT_FLOATS);
  private readonly distances = new Float64Array(5);
  private readonly magnifications = new Float64Array(5);
  /** Cosines of the angles of the five points from the line of sight. */
  private readonly viewCosines = new Float64Array(5);
  /** Spread of the second differences of the last edge [px]. */
  private spread = 0;

  constructor(metric: ScreenMetric) {
    this.metric = metric;
  }

  /** Returns 1 if the edge need not be divided; Infinity if it must be, but the number cannot be estimated. a, b: indices of its ends in `points`. */
  segments(body: ProjectedBody, points: Float64Array, a: number, b: number): number {
    if (body.needsNoCut(points, a, b) || this.pixelLength(points, a, b) < minEdgePixels(body)) return 1;
    return this.longEdgeSegments(body, points, a, b);
  }

  /**
   * What to do with an edge before its tessellation factor is computed. A factor allows `maxSegments` segments at most, and does not help where an edge has a
   * kink. SPLIT: halve it; TESSELLATE: its factor suffices; KEEP: one segment suffices.
   */
  decide(body: ProjectedBody, points: Float64Array, a: number, b: number, maxSegments: number): EdgeDecision {
    if (body.needsNoCut(points, a, b)) return KEEP;
    const length = this.pixelLength(points, a, b);
    const least = minEdgePixels(body);
    if (length < (body.kinked ? MIN_KINKED_EDGE_PIXELS : least)) return KEEP;
    const segments = this.longEdgeSegments(body, points, a, b);
    if (body.kinked && this.spread > this.metric.tolerance) return SPLIT;
    if (length < least || segments <= 1) return KEEP;
    return segments > maxSegments ? SPLIT : TESSELLATE;
  }

  private longEdgeSegments(body: ProjectedBody, points: Float64Array, a: number, b: number): number {
    this.spread = 0;
    this.sample(body, points, a, b);
    const missing = this.countMissing(points, a, b);
    if (missing === 5) return 1;
    const step = this.longestStep(points, a, b);
    if (missing > 0)
      return step < HORIZON_STEP_PIXELS || extent(points, a, b) <= HORIZON_EXTENT ? 1 : Number.POSITIVE_INFINITY;
    if (step < MIN_STEP_PIXELS) return 1;
    if (!this.isGraded(points, a, b)) return Number.POSITIVE_INFINITY;
    const difference = (body.isRound ? ROUND_STRICTNESS : 1) * this.maxSecondDifference(points, a, b);
    return Math.max(1, Math.sqrt((2 * difference) / this.metric.tolerance));
  }

  /** Upper estimate of the edge's length [px] from its ends alone, so that the many short edges of fine meshes cost little; NaN if an end does not exist. */
  private pixelLength(points: Float64Array, a: number, b: number): number {
    this.measure(points, a, 0);
    this.measure(points, b, 4);
    const least = Math.min(this.distances[0], this.distances[4]);
    const maxMagnification = Math.max(this.magnifications[0], this.magnifications[4]);
    return (distance(points, a, points, b, 0) * this.metric.view.focal * maxMagnification) / least;
  }

  /** Projects the points at ¼, ½ and ¾ of the edge. */
  private sample(body: ProjectedBody, points: Float64Array, a: number, b: number): void {
    const { inner } = this;
    for (let i = 0; i < 3; i++) {
      const at = POINT_FLOATS * i;
      // The weights are dyadic, so the result is the same from both ends.
      for (let k = 6; k < POINT_FLOATS; k++)
        inner[at + k] = points[a + k] + (points[b + k] - points[a + k]) * (0.25 * (i + 1));
      body.projectPoint(inner, at);
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

  /** Computes |F|, cos θ and 1 + tan²θ, at most that of the picture's corner, of one of the five points. */
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

  /** Length of the longest of the four quarters that exist [px]; Infinity if none does. */
  private longestStep(points: Float64Array, a: number, b: number): number {
    const { inner, magnifications: magnified } = this;
    const s1 = this.angleBetween(points, a, 0, inner, 0, 1);
    const s2 = this.angleBetween(inner, 0, 1, inner, POINT_FLOATS, 2);
    const s3 = this.angleBetween(inner, POINT_FLOATS, 2, inner, 2 * POINT_FLOATS, 3);
    const s4 = this.angleBetween(inner, 2 * POINT_FLOATS, 3, points, b, 4);
    const angle = Math.max(s1, s2, s3, s4);
    if (angle < 0) return Number.POSITIVE_INFINITY;
    let maxMagnification = 1;
    for (let k = 0; k < 5; k++) if (magnified[k] > maxMagnification) maxMagnification = magnified[k];
    return angle * this.metric.view.focal * maxMagnification;
  }

  /** The angle between the directions of two points [rad], negative if one does not exist; `from`, `to`: their indices among the five. */
  private angleBetween(p: Float64Array, i: number, from: number, q: Float64Array, k: number, to: number): number {
    const near = this.distances[from];
    const far = this.distances[to];
    const x = p[i] / near - q[k] / far;
    const y = p[i + 1] / near - q[k + 1] / far;
    const z = p[i + 2] / near - q[k + 2] / far;
    const square = x * x + y * y + z * z;
    return square >= 0 ? Math.sqrt(square) : -1;
  }

  /** Whether both the observer position and the place that edges are graded by change little enough along the edge. */
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

  /** The largest second difference [px]; sets `spread`. */
  private maxSecondDifference(points: Float64Array, a: number, b: number): number {
    const { inner } = this;
    const s1 = this.secondDifferenceAt(points, a, 0, inner, POINT_FLOATS, 1);
    const s2 = this.secondDifferenceAt(inner, 0, POINT_FLOATS, inner, 2 * POINT_FLOATS, 2);
    const s3 = this.secondDifferenceAt(points, b, 2 * POINT_FLOATS, inner, POINT_FLOATS, 3);
    const maxDifference = Math.max(s1, s2, s3);
    this.spread = maxDifference - Math.min(s1, s2, s3);
    return maxDifference;
  }

  /** `before` and `after` may be exchanged. `middle`: index in `inner`. */
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

const minEdgePixels = ({ isRound }: ProjectedBody): number => (isRound ? MIN_ROUND_EDGE_PIXELS : MIN_EDGE_PIXELS);

/** Upper bound of an edge's length as a fraction of the longest edge of its mesh triangle. */
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
