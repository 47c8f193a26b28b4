import { toMatrix } from '../../../math/quat.ts';
import { add, length, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { gamma } from '../../../physics/lorentz/boost.ts';
import { hypersurfaceOf } from '../../../physics/worldLines/hypersurface.ts';
import type { Hypersurface } from '../../../physics/worldLines/lightSurfaces.ts';
import type { SampledLine } from '../../../physics/worldLines/samples.ts';
import { samplePose } from '../../../scene/motion/poses.ts';
import { pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { SampledMotion, SampledPointsMotion } from '../../../scene/types.ts';
import type { TrianglePoints } from '../../geometry/batchSolids.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { ClusterBounds } from '../criterion/projectedBody.ts';
import type { EventBounds, HypersurfaceIntersector } from './projectedAcceleratedBody.ts';

/** Samples [first, first + count) of a motion: those that a view needs. */
export interface SampleWindow {
  readonly first: number;
  readonly count: number;
}

/** The rate of change in each piece between samples, the first being 0, and the change of the rate at each sample [1/m of light]. */
interface VelocityChanges {
  readonly rates: Float64Array;
  readonly jumps: Float64Array;
}

/** Points that move straight between samples, and are at rest before the first and after the last one. */
abstract class SampledIntersector implements HypersurfaceIntersector {
  readonly isRound: boolean = false;
  protected readonly observation: Observation;
  /** Times of the window's samples relative to the observer's event [m of light]. */
  protected readonly times: Float64Array;
  /** The place that `evaluateSample` computes [m]: observer → point, world frame. */
  protected x = 0;
  protected y = 0;
  protected z = 0;
  protected readonly surface: Hypersurface;
  protected readonly gamma: number;
  /** Whether the window has the first and the last sample of the motion, outside which it is at rest. */
  protected readonly includesStart: boolean;
  protected readonly includesEnd: boolean;

  constructor(times: Float64Array, { first, count }: SampleWindow, observation: Observation) {
    this.observation = observation;
    this.includesStart = first === 0;
    this.includesEnd = first + count === times.length;
    this.times = times.slice(first, first + count).map((t) => observation.c * (t - observation.t));
    this.gamma = gamma(observation.u);
    this.surface = hypersurfaceOf(observation);
  }

  abstract setTriangle(a: number, b: number, c: number): void;
  abstract boundsOf(cluster: ClusterBounds): EventBounds;
  /** Selects a point of the triangle. */
  protected abstract setPoint(w1: number, w2: number): void;
  /** Sets x, y, z to the place of the point at sample k of the window. */
  protected abstract evaluateSample(k: number): void;

  /**
   * The hypersurface is crossed once, since nothing moves as fast as light: bisection finds the piece, a quadratic or linear equation the event in it
   * (docs/physics.md §4.7).
   */
  intersect(w1: number, w2: number, out: Float64Array, at: number): void {
    this.setPoint(w1, w2);
    const { times } = this;
    let lo = 0;
    let hi = times.length;
    while (lo < hi) {
      const mid = (lo + hi) >>> 1;
      this.evaluateSample(mid);
      if (this.lateness(times[mid]) <= 0) lo = mid + 1;
      else hi = mid;
    }
    if (lo > 0 && lo < times.length) {
      this.intersectPiece(lo - 1, out, at);
      return;
    }
    this.evaluateSample(Math.max(0, lo - 1));
    out[at] = this.x;
    out[at + 1] = this.y;
    out[at + 2] = this.z;
  }

  /** Writes the event of the point, which is between samples k and k + 1. */
  protected intersectPiece(k: number, out: Float64Array, at: number): void {
    const { times } = this;
    this.evaluateSample(k);
    const ax = this.x;
    const ay = this.y;
    const az = this.z;
    this.evaluateSample(k + 1);
    const span = times[k + 1] - times[k];
    this.x = (this.x - ax) / span;
    this.y = (this.y - ay) / span;
    this.z = (this.z - az) / span;
    const s = Math.min(span, Math.max(0, this.crossingTime(-times[k], ax, ay, az)));
    out[at] = ax + this.x * s;
    out[at + 1] = ay + this.y * s;
    out[at + 2] = az + this.z * s;
  }

  /** Rates of change, and their jumps, of values with `size` numbers per sample. */
  protected changesOf(values: Float64Array, size: number): VelocityChanges {
    const n = this.times.length;
    const rate = (k: number, i: number): number => {
      if (k < 1) return this.includesStart ? 0 : rate(1, i);
      if (k >= n) return this.includesEnd ? 0 : rate(n - 1, i);
      return (values[size * k + i] - values[size * k - size + i]) / (this.times[k] - this.times[k - 1]);
    };
    const norm = (part: (i: number) => number) => {
      let sum = 0;
      for (let i = 0; i < size; i++) sum += part(i) ** 2;
      return Math.sqrt(sum);
    };
    const rates = new Float64Array(n);
    const jumps = new Float64Array(n);
    for (let k = 0; k < n; k++) {
      if (k > 0) rates[k] = norm((i) => rate(k, i));
      jumps[k] = norm((i) => rate(k + 1, i) - rate(k, i));
    }
    return { rates, jumps };
  }

  /** How far the event (x, t) is behind the hypersurface; it rises along every world line. */
  protected lateness(t: number): number {
    return this.surface.lateness(this.x, this.y, this.z, t, this.observation.u, this.gamma);
  }

  /** Time [m of light] from A, at T before the observer's event, to the crossing, with the velocity in x, y, z. */
  private crossingTime(T: number, ax: number, ay: number, az: number): number {
    const { x, y, z, surface, gamma } = this;
    return surface.crossingTime(T, ax, ay, az, x, y, z, this.observation.u, gamma);
  }
}

/** A rigid body: per sample its centre and its rotation. */
export class SampledPosesIntersector extends SampledIntersector {
  override readonly isRound: boolean;
  private readonly points: TrianglePoints;
  private readonly centers: Float64Array;
  private readonly rotations: Float64Array;
  /** Of the rotation matrices, by their Frobenius norm, which bounds the motion of a point at distance 1. */
  private readonly rotationChanges: VelocityChanges;

  /** `line`: of the body's centre. */
  constructor(
    motion: SampledMotion,
    line: SampledLine,
    window: SampleWindow,
    points: TrianglePoints,
    observation: Observation,
  ) {
    super(motion.times, window, observation);
    const { first, count } = window;
    this.points = points;
    this.isRound = points.isRound;
    this.centers = line.positions.slice(3 * first, 3 * (first + count)).map((x, i) => x - observation.position[i % 3]);
    this.rotations = new Float64Array(9 * count);
    for (let k = 0; k < count; k++)
      this.rotations.set(toMatrix(samplePose(motion.poses, first + k).orientation), 9 * k);
    this.rotationChanges = this.changesOf(this.rotations, 9);
  }

  setTriangle(a: number, b: number, c: number): void {
    this.points.select(a, b, c);
  }

  boundsOf({ x, y, z, radius, longestEdge }: ClusterBounds): EventBounds {
    const n = this.times.length;
    const places = new Float64Array(3 * n);
    for (let k = 0; k < n; k++) {
      this.transform(k, x, y, z);
      places[3 * k] = this.x;
      places[3 * k + 1] = this.y;
      places[3 * k + 2] = this.z;
    }
    const { rates, jumps } = this.changesOf(places, 3);
    const speed = rates.reduce((max, v, k) => Math.max(max, v + radius * this.rotationChanges.rates[k]), 0);
    const shear = longestEdge * this.rotationChanges.rates.reduce((max, rate) => Math.max(max, rate), 0);
    const sums = jumps.map((jump, k) => jump + radius * this.rotationChanges.jumps[k]);
    return {
      ...boundingSphereOf(places, radius),
      maxSpeed: speed,
      maxShear: shear,
      maxAcceleration: 0,
      maxVelocityJump: (time) => maxWithin(sums, this.times, time),
    };
  }

  protected setPoint(w1: number, w2: number): void {
    this.points.set(w1, w2);
  }

  protected evaluateSample(k: number): void {
    this.transform(k, this.points.x, this.points.y, this.points.z);
  }

  private transform(k: number, px: number, py: number, pz: number): void {
    const R = this.rotations;
    const i = 9 * k;
    this.x = R[i] * px + R[i + 1] * py + R[i + 2] * pz + this.centers[3 * k];
    this.y = R[i + 3] * px + R[i + 4] * py + R[i + 5] * pz + this.centers[3 * k + 1];
    this.z = R[i + 6] * px + R[i + 7] * py + R[i + 8] * pz + this.centers[3 * k + 2];
  }
}

/** A deforming mesh: every vertex has its own samples. Clusters are relative to the motion's origin, and bounded over the same window. */
export class SampledPointsIntersector extends SampledIntersector {
  private readonly points: readonly Float32Array[];
  private readonly origin: Vec3;
  private a = 0;
  private b = 0;
  private c = 0;
  private w1 = 0;
  private w2 = 0;

  constructor(motion: SampledPointsMotion, window: SampleWindow, observation: Observation) {
    super(motion.times, window, observation);
    this.points = Array.from({ length: window.count }, (_, i) => pointsAt(motion, window.first + i));
    this.origin = sub(motion.origin, observation.position);
  }

  setTriangle(a: number, b: number, c: number): void {
    this.a = 3 * a;
    this.b = 3 * b;
    this.c = 3 * c;
  }

  /** Whether the bend of a piece is reduced, so that velocities are not those of the cluster's bounds. */
  protected get isStraightened(): boolean {
    return false;
  }

  boundsOf({ x, y, z, radius, maxSpeed, velocityJumps, maxAcceleration = 0 }: ClusterBounds): EventBounds {
    const maxBeta = this.isStraightened ? 1 : maxSpeed / this.observation.c;
    const sums = velocityJumps?.map((jump) => jump / this.observation.c) ?? new Float64Array(this.times.length);
    return {
      center: add(this.origin, [x, y, z]),
      radius,
      maxSpeed: maxBeta,
      maxShear: 2 * maxBeta,
      maxAcceleration: maxAcceleration / this.observation.c ** 2,
      maxVelocityJump: (time) => maxWithin(sums, this.times, time),
    };
  }

  protected setPoint(w1: number, w2: number): void {
    this.w1 = w1;
    this.w2 = w2;
  }

  protected evaluateSample(k: number): void {
    const p = this.points[k];
    const o = this.origin;
    const { a, b, c, w1, w2 } = this;
    const w0 = 1 - w1 - w2;
    this.x = w0 * p[a] + w1 * p[b] + w2 * p[c] + o[0];
    this.y = w0 * p[a + 1] + w1 * p[b + 1] + w2 * p[c + 1] + o[1];
    this.z = w0 * p[a + 2] + w1 * p[b + 2] + w2 * p[c + 2] + o[2];
  }

  /** Interpolates vectors of the vertices at the point. */
  protected interpolate(of: Float32Array, out: Float64Array): void {
    const { a, b, c, w1, w2 } = this;
    const w0 = 1 - w1 - w2;
    for (let i = 0; i < 3; i++) out[i] = w0 * of[a + i] + w1 * of[b + i] + w2 * of[c + i];
  }
}

function boundingSphereOf(places: Float64Array, radius: number): { center: Vec3; radius: number } {
  const at = (i: number): Vec3 => [places[i], places[i + 1], places[i + 2]];
  const center = scale(add(at(0), at(places.length - 3)), 0.5);
  let extent = 0;
  for (let i = 0; i < places.length; i += 3) extent = Math.max(extent, length(sub(at(i), center)));
  return { center, radius: radius + extent };
}

/** The largest sum of jumps within a time. */
function maxWithin(jumps: Float64Array, times: Float64Array, time: number): number {
  let [maxSum, sum, first] = [0, 0, 0];
  for (let k = 0; k < jumps.length; k++) {
    sum += jumps[k];
    while (times[k] - times[first] > time) sum -= jumps[first++];
    maxSum = Math.max(maxSum, sum);
  }
  // For the rounding of sums and differences.
  return maxSum * (1 + 1e-9);
}
