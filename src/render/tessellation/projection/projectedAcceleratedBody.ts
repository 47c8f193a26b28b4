import type { Mat4 } from '../../../math/mat4.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import { placementOf } from '../../../physics/optics/placement.ts';
import { MAX_GRADE, MAX_GRADE_NEAR_CAMERA_PLANE } from '../criterion/edgeCriterion.ts';
import {
  type ClusterBounds,
  type ClusterState,
  CULLED,
  DRAWN,
  MIN_EDGE_PIXELS,
  MIN_KINKED_EDGE_PIXELS,
  MIN_ROUND_EDGE_PIXELS,
  type ProjectedBody,
  ROUND_STRICTNESS,
  TESSELLATED,
} from '../criterion/projectedBody.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';
import { ProjectedSphere } from './projectedSphere.ts';

/** Finds where the world lines of the points of an accelerated body meet the hypersurface of a view. */
export interface HypersurfaceIntersector {
  /** Whether its triangles stand for a round solid. */
  readonly isRound: boolean;
  /** Selects a triangle by the indices of its vertices in the batch. */
  setTriangle(a: number, b: number, c: number): void;
  /** Writes observer → event [m] of the point with these weights of the triangle's second and third corner to `out[at …]`; NaN if there is none. */
  intersect(w1: number, w2: number, out: Float64Array, at: number): void;
  /** Bounds of all events of a cluster. */
  boundsOf(cluster: ClusterBounds): EventBounds;
}

/** A sphere relative to the observer's event, world frame [m], and bounds of how its points move, in units of c. */
export interface EventBounds {
  readonly center: Vec3;
  readonly radius: number;
  /** Largest speed. */
  readonly maxSpeed: number;
  /** Largest difference between the velocities of an edge's ends at one time. */
  readonly maxShear: number;
  /** Largest acceleration apart from sudden changes [1/m of light]. */
  readonly maxAcceleration: number;
  /** The largest sum of sudden changes of a velocity within a time [m of light]. */
  readonly maxVelocityJump: (time: number) => number;
}

/** Bodies whose points have no common rest frame: their edges are judged by their events alone. */
export class ProjectedAcceleratedBody implements ProjectedBody {
  readonly kinked: boolean;
  readonly isRound: boolean;
  private readonly intersector: HypersurfaceIntersector;
  private readonly metric: ScreenMetric;
  /** From (|Y|, Y) to (|Δx′|, Δx′). */
  private readonly L: Mat4;
  private readonly sphere: ProjectedSphere;
  /** Factor of the contraction Y = Δx − k u (u·Δx). */
  private readonly contraction: number;

  constructor(intersector: HypersurfaceIntersector, kinked: boolean, metric: ScreenMetric) {
    const { observation, projection } = metric.view;
    this.intersector = intersector;
    this.kinked = kinked;
    this.isRound = intersector.isRound;
    this.metric = metric;
    const placement = placementOf(projection.place, observation.coneSlope);
    this.L = placement.boost(observation.u);
    this.sphere = new ProjectedSphere(this.L, metric);
    this.contraction = placement.contraction(observation.u);
  }

  classify(cluster: ClusterBounds): ClusterState {
    const bounds = this.intersector.boundsOf(cluster);
    const { center, radius, maxSpeed } = bounds;
    if (!(radius < Number.POSITIVE_INFINITY)) return TESSELLATED;
    const { L, metric } = this;
    const u = metric.view.observation.u;
    const contracted = this.contraction * (u[0] * center[0] + u[1] * center[1] + u[2] * center[2]);
    const [x, y, z] = [center[0] - contracted * u[0], center[1] - contracted * u[1], center[2] - contracted * u[2]];
    const { sphere } = this;
    sphere.set(x, y, z, radius);
    if (sphere.isOutside()) return CULLED;
    if (!(sphere.nearest > 0) || !(maxSpeed < 1)) return TESSELLATED;
    sphere.computeAngles();
    const longest = cluster.longestEdge / (1 - maxSpeed);
    const image = longest * Math.sqrt(2 * L[0] * sphere.maxStretch);
    const scale = (metric.view.focal * sphere.maxMagnification) / sphere.nearest;
    const least = this.isRound ? MIN_ROUND_EDGE_PIXELS : MIN_EDGE_PIXELS;
    if (image * scale < (this.kinked ? MIN_KINKED_EDGE_PIXELS : least)) return DRAWN;
    const grade = sphere.nearCameraPlane ? MAX_GRADE_NEAR_CAMERA_PLANE : MAX_GRADE;
    const graded = image < grade * sphere.nearest && longest < MAX_GRADE * sphere.minDistance;
    const round = ((cluster.bulge ?? 0) * Math.sqrt(2 * L[0] * sphere.maxStretch)) / (1 - maxSpeed);
    const bend = 2 * this.secondDifferenceBound(bounds, longest, sphere.minDistance) + round;
    return graded && (this.isRound ? ROUND_STRICTNESS : 1) * scale * bend < metric.tolerance ? DRAWN : TESSELLATED;
  }

  /**
   * Bound of the second difference of Δx′(f) over ¼ of an edge (docs/physics.md §9.2). Events of neighbouring points are also apart by the time in which the
   * points move: |Δx′(f)| and |t′(f)| are at most ℓ/(1 − v) for an edge of length ℓ at one time. Where velocities v(f) are constant, Δx″ = 2v′t′ + v t″ (plus
   * a t′² for an acceleration a), and |t″| ≤ |Δx′|²/|Δx| + |Δx″| on the light cone; where one changes by J, Δx′ jumps by at most J|t′|/(1 − v). The boost
   * maps Δx to MΔx + |Δx|m with |M| = γ, |m| = γβ.
   */
  private secondDifferenceBound(
    { maxSpeed, maxShear, maxAcceleration, maxVelocityJump }: EventBounds,
    longest: number,
    near: number,
  ): number {
    const jump = (maxVelocityJump(longest) * longest) / (1 - maxSpeed);
    const curve = (2 * maxShear * longest + (maxAcceleration + maxSpeed / near) * longest * longest) / (1 - maxSpeed);
    const delay = (longest * longest) / near + curve;
    const w = Math.hypot(this.L[1], this.L[2], this.L[3]);
    return this.L[0] * (curve / 16 + jump / 4) + w * (delay / 16 + jump / 4);
  }

  setTriangle(a: number, b: number, c: number): void {
    this.intersector.setTriangle(a, b, c);
  }

  isBackFacing(): boolean {
    return false;
  }

  projectPoint(out: Float64Array, at: number): void {
    const { L } = this;
    const { u } = this.metric.view.observation;
    this.intersector.intersect(out[at + 6], out[at + 7], out, at + 3);
    const contracted = this.contraction * (u[0] * out[at + 3] + u[1] * out[at + 4] + u[2] * out[at + 5]);
    const x = out[at + 3] - contracted * u[0];
    const y = out[at + 4] - contracted * u[1];
    const z = out[at + 5] - contracted * u[2];
    const r = Math.sqrt(x * x + y * y + z * z);
    const { vantage } = this.metric;
    out[at] = L[4] * r + L[5] * x + L[6] * y + L[7] * z - vantage[0];
    out[at + 1] = L[8] * r + L[9] * x + L[10] * y + L[11] * z - vantage[1];
    out[at + 2] = L[12] * r + L[13] * x + L[14] * y + L[15] * z - vantage[2];
  }

  /** Between graded edges the surface stays well within twice the corners' distance from their centroid. */
  isOutside(points: Float64Array, a: number, b: number, c: number): boolean {
    const x = (points[a] + points[b] + points[c]) / 3;
    const y = (points[a + 1] + points[b + 1] + points[c + 1]) / 3;
    const z = (points[a + 2] + points[b + 2] + points[c + 2]) / 3;
    const radius =
      2 * Math.max(distanceTo(points, a, x, y, z), distanceTo(points, b, x, y, z), distanceTo(points, c, x, y, z));
    for (const s of this.metric.sides) if (s[0] * x + s[1] * y + s[2] * z < -radius) return true;
    return false;
  }

  isOutsideUncut(): boolean {
    return false;
  }

  needsNoCut(): boolean {
    return false;
  }
}

function distanceTo(points: Float64Array, i: number, x: number, y: number, z: number): number {
  const dx = points[i] - x;
  const dy = points[i + 1] - y;
  const dz = points[i + 2] - z;
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}
