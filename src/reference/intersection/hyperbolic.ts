import { conjugate, rotate } from '../../math/quat.ts';
import { brent } from '../../math/roots.ts';
import { addScaled, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import type { HyperbolicMotion, SceneObject } from '../../scene/types.ts';
import { BvhTraversal } from '../acceleration/bvhTraversal.ts';
import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import {
  type Crossing,
  clipToTimes,
  createHit,
  type ObjectIntersector,
  type RayQuery,
} from '../acceleration/rayQuery.ts';
import { type TriangleBvh, triangleNormal } from '../acceleration/triangleBvh.ts';
import { BarycentricTest } from './barycentrics.ts';

const traversal = new BvhTraversal();
const corners = new BarycentricTest();

/** Greatest distance of a chord from the ray's curve, as a fraction of the object's size. */
const MAX_CHORD_ERROR = 0.05;
/** Rays are searched up to this many times the lengths involved, c²/a among them; γ is about this there. */
const MAX_GAMMA = 1e8;
/** Rounding error of a point on the curve in units of the last place, and its upper bound as a fraction of the object's size. */
const ROUNDINGS = 32;
const MAX_NOISE = 1e-6;

type HyperbolicObject = SceneObject & { readonly motion: HyperbolicMotion };

/** A ray in the object's own frame: the curve o + s d − A D(s), with the coordinate X + s X′ along A and the time τ + s τ′ [m]. */
interface ObjectRayCurve {
  readonly o: Vec3;
  readonly d: Vec3;
  readonly X: number;
  readonly dX: number;
  readonly tau: number;
  readonly dTau: number;
}

/**
 * Intersects rays with an object in hyperbolic motion; k = a/c², and A is the unit vector along the acceleration a. An object authored in the world
 * frame is displaced along A by D = kτ²/(1 + S), S = √(1 + (kτ)²). A Born-rigid one is at rest in Rindler's coordinate √((1 + kX)² − (kτ)²)/k,
 * which is D = kτ²/(1 + kX + S) behind X, S = √((1 + kX)² − (kτ)²); it is nowhere beyond the horizon |kτ| = 1 + kX. In both cases D is a convex
 * function of s, so in the object's frame the ray is a plane curve that bends one way. Source: Rindler, Relativity, §3.8; docs/physics.md §10.3.
 */
export class HyperbolicRayIntersector implements ObjectIntersector {
  readonly bounds = undefined;
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: HyperbolicObject;
  private readonly shape: TriangleBvh;
  private readonly c: number;
  /** [1/m] */
  private readonly k: number;
  private readonly rigid: boolean;
  /** A on the world's axes, and on the object's. */
  private readonly along: Vec3;
  private readonly A: Vec3;
  /** [m] */
  private readonly size: number;

  constructor(index: number, object: HyperbolicObject, shape: TriangleBvh, c: number) {
    const { pose, properAcceleration } = object.motion;
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.shape = shape;
    this.c = c;
    this.k = length(properAcceleration) / (c * c);
    this.rigid = object.authoredIn === 'rest';
    this.along = normalize(properAcceleration);
    this.A = rotate(conjugate(pose.orientation), this.along);
    this.size = Math.max(0, ...shape.bvh.bounds.subarray(0, 6).map(Math.abs));
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { birth, death } = this.object.lifetime;
    const curve = this.curveOf(ray);
    const [begin, end] = clipToTimes(ray, birth, death, this.c, search.begin, search.end);
    const [from, to] = this.horizons(curve, begin, Math.min(end, this.farthest(curve)));
    if (from < to) this.divide(curve, from, to, search);
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const { k, rigid, along } = this;
    const { X, dX, tau, dTau } = this.curveOf(ray);
    const [place, time] = [k * (X + crossing.s * dX), k * (tau + crossing.s * dTau)];
    const speed = rigid ? time / (1 + place) : time / Math.hypot(1, time);
    const plane = rotate(this.object.motion.pose.orientation, triangleNormal(this.object.mesh, crossing.corner));
    const N = rigid ? plane : contraction(plane, scale(along, time));
    return createHit(ray, this.index, crossing, this.c, scale(along, speed), N);
  }

  private curveOf({ t, x, dt, dx }: SpacetimeRay): ObjectRayCurve {
    const { pose, t0 } = this.object.motion;
    const turn = conjugate(pose.orientation);
    const from = sub(x, pose.position);
    const { along, c } = this;
    return {
      o: rotate(turn, from),
      d: rotate(turn, dx),
      X: dot(along, from),
      dX: dot(along, dx),
      tau: c * (t - t0),
      dTau: dt,
    };
  }

  /** Upper bound of s. */
  private farthest({ o, d, tau, dTau }: ObjectRayCurve): number {
    const reach = length(o) + Math.abs(tau) + this.size + (this.k > 0 ? 1 / this.k : 0);
    return (MAX_GAMMA * reach) / Math.max(length(d), Math.abs(dTau));
  }

  /** The part of [begin, end] within the horizons of a Born-rigid object, 1 + kX ± kτ > 0. */
  private horizons({ X, dX, tau, dTau }: ObjectRayCurve, begin: number, end: number): readonly [number, number] {
    let [from, to] = [begin, end];
    if (!this.rigid) return [from, to];
    for (const sign of [1, -1]) {
      const inside = 1 + this.k * (X + sign * tau);
      const rate = this.k * (dX + sign * dTau);
      if (rate > 0) from = Math.max(from, -inside / rate);
      else if (rate < 0) to = Math.min(to, -inside / rate);
      else if (inside <= 0) return [1, 0];
    }
    return [from, to];
  }

  private root(place: number, time: number): number {
    return this.rigid ? Math.sqrt(Math.max(0, (1 + place - time) * (1 + place + time))) : Math.hypot(1, time);
  }

  /** D [m] */
  private lag({ X, dX, tau, dTau }: ObjectRayCurve, s: number): number {
    const time = tau + s * dTau;
    const place = this.rigid ? this.k * (X + s * dX) : 0;
    return (this.k * time * time) / (1 + place + this.root(place, this.k * time));
  }

  /** dD/ds; infinite at a horizon. */
  private lagRate({ X, dX, tau, dTau }: ObjectRayCurve, s: number): number {
    const time = this.k * (tau + s * dTau);
    const place = this.rigid ? this.k * (X + s * dX) : 0;
    const root = this.root(place, time);
    return this.rigid ? dX - ((1 + place) * dX - time * dTau) / root : (time * dTau) / root;
  }

  /** Halves the curve until chords approximate it, near parts first, and skips parts that miss the object's boxes. */
  private divide(curve: ObjectRayCurve, from: number, to: number, search: RayQuery): void {
    if (from > search.end) return;
    const [a, b] = [this.lag(curve, from), this.lag(curve, to)];
    const bulge = convexBulge(a, b, this.lagRate(curve, from), this.lagRate(curve, to), to - from);
    const middle = from + (to - from) / 2;
    const divisible = middle > from && middle < to;
    if (bulge < MAX_CHORD_ERROR * this.size || !divisible) {
      this.intersectChord(curve, from, to, a, b, bulge, search);
      return;
    }
    if (bulge < Number.POSITIVE_INFINITY) {
      this.startTraversal(curve, from, to, a, b, bulge);
      if (traversal.next(to - from) < 0) return;
    }
    this.divide(curve, from, middle, search);
    this.divide(curve, middle, to, search);
  }

  /** Starts a traversal along the chord for the curve, which deviates from it by up to `bulge` along A. */
  private startTraversal(
    { o, d }: ObjectRayCurve,
    from: number,
    to: number,
    a: number,
    b: number,
    bulge: number,
  ): void {
    const { A } = this;
    const begin = addScaled(addScaled(o, d, from), A, -a);
    const rate = to > from ? (b - a) / (to - from) : 0;
    const direction = addScaled(d, A, -rate);
    const noise = this.noise(o, d, to, b);
    traversal.start(this.shape.bvh, [...begin, ...direction], 0);
    traversal.thicken(scale(A, bulge), noise);
  }

  private noise(o: Vec3, d: Vec3, s: number, lag: number): number {
    return Math.min(MAX_NOISE * this.size, ROUNDINGS * Number.EPSILON * (length(o) + s * length(d) + lag + this.size));
  }

  private intersectChord(
    curve: ObjectRayCurve,
    from: number,
    to: number,
    a: number,
    b: number,
    bulge: number,
    search: RayQuery,
  ): void {
    this.startTraversal(curve, from, to, a, b, bulge);
    const { bvh, first } = this.shape;
    for (let leaf = traversal.next(search.end - from); leaf >= 0; leaf = traversal.next(search.end - from)) {
      const start = bvh.link[leaf];
      for (let i = start; i < start + bvh.count[leaf]; i++) this.intersectTriangle(curve, from, to, first[i], search);
    }
  }

  /** g(s) = N·(p − y(s)) is convex or concave, hence monotonic between its ends and its extremum: sign changes bracket the roots. */
  private intersectTriangle(curve: ObjectRayCurve, from: number, to: number, corner: number, search: RayQuery): void {
    const { mesh } = this.object;
    const N = normalize(triangleNormal(mesh, corner));
    const p = pointAt(mesh.positions, mesh.indices[corner]);
    const n = dot(N, this.A);
    const start = dot(N, sub(p, curve.o));
    const rate = dot(N, curve.d);
    const g = (s: number) => start - s * rate + n * this.lag(curve, s);
    const slope = (s: number) => n * this.lagRate(curve, s) - rate;
    const noise = this.noise(curve.o, curve.d, to, this.lag(curve, to));
    const turns = slope(from) < 0 !== slope(to) < 0;
    const extremum = turns ? brent(slope, from, to) : to;
    const intervals = turns ? [from, extremum, to] : [from, to];
    for (let i = 0; i + 1 < intervals.length; i++) {
      const s = rootBetween(g, intervals[i], intervals[i + 1], noise);
      if (s !== undefined && this.tryAt(curve, s, slope(s), corner, noise, search)) return;
    }
  }

  private tryAt(
    curve: ObjectRayCurve,
    s: number,
    slope: number,
    corner: number,
    noise: number,
    search: RayQuery,
  ): boolean {
    const { mesh } = this.object;
    const y = addScaled(addScaled(curve.o, curve.d, s), this.A, -this.lag(curve, s));
    for (let i = 0; i < 3; i++) corners.q.set(sub(pointAt(mesh.positions, mesh.indices[corner + i]), y), 3 * i);
    const speed = length(addScaled(curve.d, this.A, -this.lagRate(curve, s)));
    if (!corners.contains(noise, speed, Math.abs(slope))) return false;
    return search.offer(this, s, corner, corners.v, corners.w, slope > 0, 0);
  }
}

/**
 * Upper bound of the distance of a convex function below its chord, from its values and slopes at both ends: the distance of the point where the
 * two tangents meet.
 */
function convexBulge(a: number, b: number, rateA: number, rateB: number, span: number): number {
  if (span === 0) return 0;
  const chord = (b - a) / span;
  const [below, above] = [Math.max(0, chord - rateA), Math.max(0, rateB - chord)];
  if (below === 0 || above === 0) return 0;
  return span / (1 / below + 1 / above);
}

function rootBetween(g: (s: number) => number, from: number, to: number, noise: number): number | undefined {
  const [a, b] = [g(from), g(to)];
  if (a < 0 !== b < 0) return brent(g, from, to);
  if (Math.abs(a) <= noise) return from;
  return Math.abs(b) <= noise ? to : undefined;
}
