import { conjugate, rotate } from '../../math/quat.ts';
import { dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import type { ObjectWith } from '../../scene/motion/kinds/motionKind.ts';
import type { HyperbolicMotion, Pose } from '../../scene/types.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';

/** Rays are searched up to this many times the lengths involved, c²/a among them; γ is about this there. */
const MAX_GAMMA = 1e8;
/** Rounding error of a point on the curve in units of the last place, and its upper bound as a fraction of the object's size. */
const ROUNDINGS = 32;
const MAX_NOISE = 1e-6;

/** A ray in the object's own frame: the curve o + s d − A D(s), with the coordinate X + s X′ along A and the time τ + s τ′ [m]. */
export interface ObjectRayCurve {
  readonly o: Vec3;
  readonly d: Vec3;
  readonly X: number;
  readonly dX: number;
  readonly tau: number;
  readonly dTau: number;
}

/**
 * The frame of an object in hyperbolic motion; k = a/c², and A is the unit vector along the acceleration a. An object authored in the world frame is
 * displaced along A by D = kτ²/(1 + S), S = √(1 + (kτ)²). A Born-rigid one is at rest in Rindler's coordinate √((1 + kX)² − (kτ)²)/k, which is
 * D = kτ²/(1 + kX + S) behind X, S = √((1 + kX)² − (kτ)²); it is nowhere beyond the horizon |kτ| = 1 + kX. In both cases D is a convex function of s,
 * so in the object's frame the ray is a plane curve that bends one way. Source: Rindler, Relativity, §3.8; docs/physics.md §10.3.
 */
export class HyperbolicFrame {
  /** A on the object's axes. */
  readonly A: Vec3;
  private readonly motion: HyperbolicMotion;
  private readonly c: number;
  /** [1/m] */
  private readonly k: number;
  private readonly rigid: boolean;
  /** A on the world's axes. */
  private readonly along: Vec3;
  /** The greatest distance of a point of the object from its origin [m]. */
  private readonly size: number;

  constructor({ motion, authoredIn }: ObjectWith<HyperbolicMotion>, size: number, c: number) {
    this.motion = motion;
    this.c = c;
    this.k = length(motion.properAcceleration) / (c * c);
    this.rigid = authoredIn === 'rest';
    this.along = normalize(motion.properAcceleration);
    this.A = rotate(conjugate(motion.pose.orientation), this.along);
    this.size = size;
  }

  curveOf({ t, x, dt, dx }: SpacetimeRay): ObjectRayCurve {
    const { pose, t0 } = this.motion;
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

  /** The surface's velocity [c] and its rest-frame normal where the ray is at s and the mesh has the normal `plane`. */
  surfaceAt({ X, dX, tau, dTau }: ObjectRayCurve, s: number, plane: Vec3): { velocity: Vec3; normal: Vec3 } {
    const { k, rigid, along } = this;
    const { orientation }: Pose = this.motion.pose;
    const [place, time] = [k * (X + s * dX), k * (tau + s * dTau)];
    const speed = rigid ? time / (1 + place) : time / Math.hypot(1, time);
    const turned = rotate(orientation, plane);
    return {
      velocity: scale(along, speed),
      normal: rigid ? turned : contraction(turned, scale(along, time)),
    };
  }

  /** The part of [begin, end] where the object is: within the horizons of a Born-rigid one, 1 + kX ± kτ > 0, and not too far to count. */
  extent(curve: ObjectRayCurve, begin: number, end: number): readonly [number, number] {
    const { X, dX, tau, dTau } = curve;
    let [from, to] = [begin, Math.min(end, this.farthest(curve))];
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

  /** Upper bound of s. */
  private farthest({ o, d, tau, dTau }: ObjectRayCurve): number {
    const reach = length(o) + Math.abs(tau) + this.size + (this.k > 0 ? 1 / this.k : 0);
    return (MAX_GAMMA * reach) / Math.max(length(d), Math.abs(dTau));
  }

  private root(place: number, time: number): number {
    return this.rigid ? Math.sqrt(Math.max(0, (1 + place - time) * (1 + place + time))) : Math.hypot(1, time);
  }

  /** D [m] */
  lag({ X, dX, tau, dTau }: ObjectRayCurve, s: number): number {
    const time = tau + s * dTau;
    const place = this.rigid ? this.k * (X + s * dX) : 0;
    return (this.k * time * time) / (1 + place + this.root(place, this.k * time));
  }

  /** dD/ds; infinite at a horizon. */
  lagRate({ X, dX, tau, dTau }: ObjectRayCurve, s: number): number {
    const time = this.k * (tau + s * dTau);
    const place = this.rigid ? this.k * (X + s * dX) : 0;
    const root = this.root(place, time);
    return this.rigid ? dX - ((1 + place) * dX - time * dTau) / root : (time * dTau) / root;
  }

  /**
   * Upper bound of D″ between two places: k τ′²/S³, and for a Born-rigid object k ((1 + kX)τ′ − kτX′)²/S³, whose numerator is constant. S² is quadratic
   * in s, so its least value is at an end or at its vertex.
   */
  lagBend({ X, dX, tau, dTau }: ObjectRayCurve, from: number, to: number): number {
    const { k, rigid } = this;
    const squared = (s: number) => {
      const [place, time] = [rigid ? k * (X + s * dX) : 0, k * (tau + s * dTau)];
      return this.root(place, time) ** 2;
    };
    const turn = rigid
      ? -((1 + k * X) * dX - k * tau * dTau) / (k * (dX * dX - dTau * dTau))
      : dTau === 0
        ? from
        : -tau / dTau;
    const least = Math.min(squared(from), squared(to), turn > from && turn < to ? squared(turn) : squared(from));
    const numerator = rigid ? (1 + k * X) * dTau - k * tau * dX : dTau;
    return (k * numerator * numerator) / (least * Math.sqrt(least));
  }

  /** Rounding error of the curve's points at s [m]. */
  noise({ o, d }: ObjectRayCurve, s: number, lag: number): number {
    return Math.min(MAX_NOISE * this.size, ROUNDINGS * Number.EPSILON * (length(o) + s * length(d) + lag + this.size));
  }
}

/**
 * Upper bound of the distance of a convex function below its chord, from its values and slopes at both ends: the distance of the point where the
 * two tangents meet.
 */
export function convexBulge(a: number, b: number, rateA: number, rateB: number, span: number): number {
  if (span === 0) return 0;
  const chord = (b - a) / span;
  const [below, above] = [Math.max(0, chord - rateA), Math.max(0, rateB - chord)];
  if (below === 0 || above === 0) return 0;
  return span / (1 / below + 1 / above);
}
