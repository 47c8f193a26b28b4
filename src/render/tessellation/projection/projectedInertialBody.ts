import { type Mat3, multiply as times, transform } from '../../../math/mat3.ts';
import { IDENTITY, type Mat4, multiply } from '../../../math/mat4.ts';
import { type Quat, toMatrix } from '../../../math/quat.ts';
import { add, addScaled, dot, length, scale, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { boostMatrix, gamma, properVelocity } from '../../../physics/lorentz/boost.ts';
import { relativeVelocity } from '../../../physics/lorentz/velocity.ts';
import { placementOf } from '../../../physics/optics/placement.ts';
import type { HypersurfaceName } from '../../../physics/worldLines/hypersurface.ts';
import type { InertialLine } from '../../../physics/worldLines/kinds/worldLineKind.ts';
import { slowed } from '../../../physics/worldLines/shallowCone.ts';
import { contraction, simultaneitySlice, simultaneousPosition } from '../../../physics/worldLines/simultaneity.ts';
import type { TrianglePoints } from '../../geometry/batchSolids.ts';
import type { Observation } from '../../geometry/observation.ts';
import { DEPTH_WEIGHT, MAX_GRADE_NEAR_CAMERA_PLANE } from '../criterion/edgeCriterion.ts';
import {
  type ClusterBounds,
  type ClusterState,
  CULLED,
  DRAWN,
  MIN_EDGE_PIXELS,
  MIN_ROUND_EDGE_PIXELS,
  type ProjectedBody,
  ROUND_STRICTNESS,
  TESSELLATED,
} from '../criterion/projectedBody.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';
import { ProjectedSphere } from './projectedSphere.ts';

/**
 * A triangle whose longest edge this is lies within this many times its length from the edge's middle (√3/2, rounded up): the farthest corner is that of an
 * equilateral triangle.
 */
const EDGE_REACH = 0.87;

/**
 * How a body at constant velocity is projected (docs/physics.md §9.2): a point p of its batch is at X = Ap + x₀, in coordinates in which the matrix L maps
 * (|X|, X) to (|Δx′|, Δx′). On the light cone, X is the place in the body's rest frame, and L boosts from there to the world and on to the observer.
 * Δx′ = MX + |X|m, |m| = γβ: straight edges stay straight but for |X|, whose second derivative along an edge of length ℓ is at most ℓ²/|X|, so a chord is off
 * by at most |m|ℓ²/(8|X|). Its image is at the distance D|X|, and at most √(2γD) times as long: √(2γD − 1) along the line of sight, 1 across.
 */
export interface InertialMap {
  /** 3 × 3, row-major. */
  readonly A: readonly number[];
  readonly x0: Vec3;
  readonly L: Mat4;
  /** Largest factor by which A lengthens a vector. */
  readonly maxStretch: number;
}

/** `line`: of the body's centre; `bornRigid`: the body's offsets are those of its rest frame; `size`: a typical length of the body [m]. */
export function inertialMap(line: InertialLine, bornRigid: boolean, size: number, { view }: ScreenMetric): InertialMap {
  const { observation, projection } = view;
  const v = properVelocity(scale(line.velocity, 1 / observation.c));
  const toObserver = placementOf(projection.place, observation.coneSlope).boost(observation.u);
  const now = sub(addScaled(line.position, line.velocity, observation.t), observation.position);
  return MAPS[observation.hypersurface]({ line, bornRigid, size, v, toObserver, now, observation });
}

interface MapInputs {
  readonly line: InertialLine;
  readonly bornRigid: boolean;
  readonly size: number;
  /** γβ of the body. */
  readonly v: Vec3;
  /** From (|Δx|, Δx) to (|Δx′|, Δx′). */
  readonly toObserver: Mat4;
  /** The body's place at the observer's world time, relative to the observer. */
  readonly now: Vec3;
  readonly observation: Observation;
}

const worldOffset = ({ bornRigid, v }: MapInputs, p: Vec3): Vec3 => (bornRigid ? contraction(p, v) : p);

/** A and x₀ of the places in the observer's slice. */
function sliceMap(inputs: MapInputs): Omit<InertialMap, 'L'> {
  const { line, size, observation } = inputs;
  const place = (p: Vec3): Vec3 => {
    const position = add(line.position, worldOffset(inputs, p));
    const shifted = { kind: 'uniform', position, velocity: line.velocity } as const;
    return simultaneousPosition(
      simultaneitySlice(shifted, observation, observation.u, observation.c).offset,
      observation.u,
    );
  };
  const x0 = place(ZERO);
  const A = matrixOf((p) => scale(sub(place(scale(p, size)), x0), 1 / size));
  return { A, x0, maxStretch: normBound(A) };
}

const MAPS: Readonly<Record<HypersurfaceName, (inputs: MapInputs) => InertialMap>> = {
  'past-light-cone'({ bornRigid, v, now, toObserver }) {
    const A = bornRigid ? matrixOf((p) => p) : matrixOf((p) => uncontracted(p, v));
    return { A, x0: uncontracted(now, v), L: multiply(toObserver, boostMatrix(v)), maxStretch: normBound(A) };
  },
  slice: (inputs) => ({ ...sliceMap(inputs), L: IDENTITY }),
  // In the slowed world: from the slice to the rest frame of the slowed velocity, and on to the observer.
  'shallow-cone'(inputs) {
    const { v, observation } = inputs;
    const w = slowed(relativeVelocity(v, observation.u), observation.coneSlope);
    const slice = sliceMap(inputs);
    const A = matrixOf((p) => uncontracted(transform(slice.A, p), w));
    return { A, x0: uncontracted(slice.x0, w), L: boostMatrix(w), maxStretch: normBound(A) };
  },
  now(inputs) {
    const A = matrixOf((p) => worldOffset(inputs, p));
    return { A, x0: inputs.now, L: inputs.toObserver, maxStretch: normBound(A) };
  },
};

/** The map for points in the axes of a mesh that is stretched and rotated. */
export function mapOfMesh(map: InertialMap, orientation: Quat, stretch?: Mat3): InertialMap {
  const A = times(map.A, toMatrix(orientation));
  if (!stretch) return { ...map, A };
  const stretched = times(A, stretch);
  return { ...map, A: stretched, maxStretch: normBound(stretched) };
}

/** From the world's slice to the rest frame: the inverse of the contraction (docs/physics.md §5.5). */
const uncontracted = (x: Vec3, u: Vec3): Vec3 => addScaled(x, u, dot(u, x) / (gamma(u) + 1));

/** The matrix of a linear function, row-major. */
function matrixOf(f: (p: Vec3) => Vec3): number[] {
  const [a, b, c] = [f([1, 0, 0]), f([0, 1, 0]), f([0, 0, 1])];
  return [a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]];
}

export class ProjectedInertialBody implements ProjectedBody {
  readonly kinked = false;
  readonly isRound: boolean;
  private readonly metric: ScreenMetric;
  private readonly map: InertialMap;
  private readonly points: TrianglePoints;
  private readonly doubleSided: boolean;
  /** The picture's sides for (|X|, X): b|X| + a·X ≥ k inside. */
  private readonly sides: readonly { readonly a: Vec3; readonly b: number; readonly k: number }[];
  /** γ and u = γβ of the observer in the frame of X, and |u|. */
  private readonly gamma: number;
  private readonly u: Vec3;
  private readonly w: number;
  private readonly sphere: ProjectedSphere;
  private readonly maxStretch: number;
  /** X of the selected triangle's corners. */
  private readonly corners = new Float64Array(9);

  constructor(map: InertialMap, points: TrianglePoints, doubleSided: boolean, metric: ScreenMetric) {
    const { L } = map;
    this.map = map;
    this.metric = metric;
    this.points = points;
    this.isRound = points.isRound;
    this.doubleSided = doubleSided;
    this.gamma = L[0];
    this.u = [L[1], L[2], L[3]];
    this.w = length(this.u);
    this.sphere = new ProjectedSphere(L, metric);
    this.maxStretch = map.maxStretch;
    const row = (i: number): Vec3 => [L[4 + i], L[8 + i], L[12 + i]];
    this.sides = metric.sides.map((s) => ({
      a: [dot(s, row(1)), dot(s, row(2)), dot(s, row(3))],
      b: dot(s, row(0)),
      k: dot(s, metric.vantage),
    }));
  }

  classify(cluster: ClusterBounds): ClusterState {
    const { A, x0 } = this.map;
    const { x, y, z } = cluster;
    const cx = A[0] * x + A[1] * y + A[2] * z + x0[0];
    const cy = A[3] * x + A[4] * y + A[5] * z + x0[1];
    const cz = A[6] * x + A[7] * y + A[8] * z + x0[2];
    const radius = this.maxStretch * cluster.radius;
    this.sphere.set(cx, cy, cz, radius);
    if (this.sphere.isOutside()) return CULLED;
    const longest = this.maxStretch * cluster.longestEdge;
    return this.mayBend(cx, cy, cz, radius, longest, this.maxStretch * (cluster.bulge ?? 0)) ? TESSELLATED : DRAWN;
  }

  setTriangle(a: number, b: number, c: number): void {
    const { points } = this;
    points.select(a, b, c);
    this.placeCorner(0, 0, 0);
    this.placeCorner(1, 0, 3);
    this.placeCorner(0, 1, 6);
  }

  isBackFacing(): boolean {
    // A round solid may show more than its triangles, and so may what is seen from elsewhere.
    if (this.doubleSided || this.isRound || this.metric.view.vantage) return false;
    const X = this.corners;
    const ex = X[3] - X[0];
    const ey = X[4] - X[1];
    const ez = X[5] - X[2];
    const fx = X[6] - X[0];
    const fy = X[7] - X[1];
    const fz = X[8] - X[2];
    const nx = ey * fz - ez * fy;
    const ny = ez * fx - ex * fz;
    const nz = ex * fy - ey * fx;
    const height = nx * X[0] + ny * X[1] + nz * X[2];
    const square = (nx * nx + ny * ny + nz * nz) * (X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
    return height > 1e-6 * Math.sqrt(square);
  }

  projectPoint(out: Float64Array, at: number): void {
    const X = this.corners;
    const { L } = this.map;
    const w1 = out[at + 6];
    const w2 = out[at + 7];
    const w0 = 1 - w1 - w2;
    let x = w0 * X[0] + w1 * X[3] + w2 * X[6];
    let y = w0 * X[1] + w1 * X[4] + w2 * X[7];
    let z = w0 * X[2] + w1 * X[5] + w2 * X[8];
    if (this.isRound) {
      const { A, x0 } = this.map;
      const p = this.points;
      p.set(w1, w2);
      x = A[0] * p.x + A[1] * p.y + A[2] * p.z + x0[0];
      y = A[3] * p.x + A[4] * p.y + A[5] * p.z + x0[1];
      z = A[6] * p.x + A[7] * p.y + A[8] * p.z + x0[2];
    }
    const r = Math.sqrt(x * x + y * y + z * z);
    const { vantage } = this.metric;
    out[at] = L[4] * r + L[5] * x + L[6] * y + L[7] * z - vantage[0];
    out[at + 1] = L[8] * r + L[9] * x + L[10] * y + L[11] * z - vantage[1];
    out[at + 2] = L[12] * r + L[13] * x + L[14] * y + L[15] * z - vantage[2];
    out[at + 3] = x;
    out[at + 4] = y;
    out[at + 5] = z;
  }

  isOutside(points: Float64Array, a: number, b: number, c: number): boolean {
    return this.isOutsideUncut(points, a, b, c);
  }

  /**
   * Over the triangle, b|X| + a·X is convex where b ≥ 0, so it is greatest at a corner; where b < 0 it is concave, and nowhere above its tangent (a + bn)·X
   * at the centroid, n = X/|X| there.
   */
  isOutsideUncut(points: Float64Array, i: number, j: number, k: number): boolean {
    const mx = points[i + 3] + points[j + 3] + points[k + 3];
    const my = points[i + 4] + points[j + 4] + points[k + 4];
    const mz = points[i + 5] + points[j + 5] + points[k + 5];
    const distance = Math.sqrt(mx * mx + my * my + mz * mz);
    if (distance === 0) return false;
    if (this.isRound) return this.isBallOutside(points, i, j, k, mx / 3, my / 3, mz / 3);
    for (const { a, b, k: least } of this.sides) {
      const convex = b >= 0;
      const ax = convex ? a[0] : a[0] + (b * mx) / distance;
      const ay = convex ? a[1] : a[1] + (b * my) / distance;
      const az = convex ? a[2] : a[2] + (b * mz) / distance;
      const bend = convex ? b : 0;
      const maxSide = Math.max(
        side(points, i, ax, ay, az, bend),
        side(points, j, ax, ay, az, bend),
        side(points, k, ax, ay, az, bend),
      );
      if (maxSide < least - 1e-9 * distance * this.gamma) return true;
    }
    return false;
  }

  /** A round surface stays within twice the corners' distance from their centroid. */
  private isBallOutside(p: Float64Array, i: number, j: number, k: number, x: number, y: number, z: number): boolean {
    const away = (at: number) => Math.hypot(p[at + 3] - x, p[at + 4] - y, p[at + 5] - z);
    this.sphere.set(x, y, z, 2 * Math.max(away(i), away(j), away(k)));
    return this.sphere.isOutside();
  }

  needsNoCut(points: Float64Array, a: number, b: number): boolean {
    if (this.isRound) return false;
    const dx = points[a + 3] - points[b + 3];
    const dy = points[a + 4] - points[b + 4];
    const dz = points[a + 5] - points[b + 5];
    const x = 0.5 * (points[a + 3] + points[b + 3]);
    const y = 0.5 * (points[a + 4] + points[b + 4]);
    const z = 0.5 * (points[a + 5] + points[b + 5]);
    return !this.mayBend(x, y, z, 0, Math.sqrt(dx * dx + dy * dy + dz * dz), 0);
  }

  /** Whether a chord no longer than `longest` in a sphere, or a triangle of three of them, may deviate too much from what is seen, which is `bulge` off it. */
  private mayBend(x: number, y: number, z: number, radius: number, longest: number, bulge: number): boolean {
    const { w, sphere } = this;
    sphere.set(x, y, z, radius + EDGE_REACH * longest);
    if (!(sphere.nearest > 0)) return true;
    sphere.computeAngles();
    const scale = this.metric.view.focal / sphere.nearest;
    const image = longest * Math.sqrt(2 * this.gamma * sphere.maxStretch);
    const least = this.isRound ? MIN_ROUND_EDGE_PIXELS : MIN_EDGE_PIXELS;
    if (image * scale * sphere.maxMagnification < least) return false;
    if (sphere.nearCameraPlane && image > MAX_GRADE_NEAR_CAMERA_PLANE * sphere.nearest) return true;
    const across = sphere.maxSine * sphere.maxMagnification;
    const curvature = w * Math.sqrt(across * across + DEPTH_WEIGHT * DEPTH_WEIGHT);
    const round = bulge * Math.sqrt(2 * this.gamma * sphere.maxStretch) * scale * sphere.maxMagnification;
    const off = (curvature * longest * longest * scale) / (8 * sphere.minDistance) + round;
    return !((this.isRound ? ROUND_STRICTNESS : 1) * off < this.metric.tolerance);
  }

  private placeCorner(w1: number, w2: number, to: number): void {
    const { A, x0 } = this.map;
    this.points.set(w1, w2);
    const { x, y, z } = this.points;
    this.corners[to] = A[0] * x + A[1] * y + A[2] * z + x0[0];
    this.corners[to + 1] = A[3] * x + A[4] * y + A[5] * z + x0[1];
    this.corners[to + 2] = A[6] * x + A[7] * y + A[8] * z + x0[2];
  }
}

/** Upper bound of a matrix's spectral norm: √(largest row sum × largest column sum) of absolute values. */
function normBound(A: readonly number[]): number {
  const row = (i: number) => Math.abs(A[i]) + Math.abs(A[i + 1]) + Math.abs(A[i + 2]);
  const column = (i: number) => Math.abs(A[i]) + Math.abs(A[i + 3]) + Math.abs(A[i + 6]);
  return Math.sqrt(Math.max(row(0), row(3), row(6)) * Math.max(column(0), column(1), column(2)));
}

const side = (p: Float64Array, i: number, ax: number, ay: number, az: number, b: number): number => {
  const x = p[i + 3];
  const y = p[i + 4];
  const z = p[i + 5];
  const r = b > 0 ? b * Math.sqrt(x * x + y * y + z * z) : 0;
  return ax * x + ay * y + az * z + r;
};
