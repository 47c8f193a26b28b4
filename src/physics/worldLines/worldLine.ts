import { fromAxisAngle, rotate } from '../../math/quat.ts';
import { add, addScaled, cross, dot, lerp, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { type CubicPiece, cubicAt } from './cubicPiece.ts';

/** The world line of one point in the world frame; SI units. */
export type WorldLine = StaticLine | UniformLine | HyperbolicLine | CircularLine | PolylineLine | CubicLine;

export interface StaticLine {
  readonly kind: 'static';
  /** [m] */
  readonly position: Vec3;
}
export interface UniformLine {
  readonly kind: 'uniform';
  /** At t = 0 [m]. */
  readonly position: Vec3;
  /** [m/s], |v| < c. */
  readonly velocity: Vec3;
}
/** Constant proper acceleration for all times, momentarily at rest at t0. Zero acceleration means at rest. */
export interface HyperbolicLine {
  readonly kind: 'hyperbolic';
  /** At t0 [m]. */
  readonly position: Vec3;
  /** [m/s²] */
  readonly properAcceleration: Vec3;
  /** [s] */
  readonly t0: number;
}
/** Circular motion at constant speed. */
export interface CircularLine {
  readonly kind: 'circular';
  /** [m] */
  readonly center: Vec3;
  /** Unit; the rotation is right-handed about it. */
  readonly axis: Vec3;
  /** From the centre to the point at t = 0 [m]. */
  readonly arm: Vec3;
  /** [rad/s], |ω| |arm| < c. */
  readonly angularVelocity: number;
}
/** A point given at samples; at rest before the first and after the last one. */
interface SampledLine {
  /** [s], strictly increasing, at least one. */
  readonly times: Float64Array;
  /** 3 per sample [m]. */
  readonly positions: Float64Array;
}
/** Straight pieces between samples. */
export interface PolylineLine extends SampledLine {
  readonly kind: 'polyline';
}
/** Cubic pieces between samples. */
export interface CubicLine extends SampledLine {
  readonly kind: 'cubic';
  /** 6 per piece: its velocities at the start and the end [m/s]. All control velocities (`controlVelocities`) are below c. */
  readonly velocities: Float64Array;
}

/** The line where it is straight between samples; else undefined. */
export const asPolyline = (w: WorldLine): PolylineLine | undefined => (w.kind === 'polyline' ? w : undefined);

/** The line where its velocity is always the same; else undefined. */
export const asInertial = (w: WorldLine): StaticLine | UniformLine | undefined =>
  w.kind === 'static' || w.kind === 'uniform' ? w : undefined;

/** The constant velocity of a line, 0 at rest [m/s]. */
export const inertialVelocity = (w: StaticLine | UniformLine): Vec3 => (w.kind === 'uniform' ? w.velocity : ZERO);

/** Sample i [m]. */
export const samplePosition = (w: SampledLine, i: number): Vec3 => [
  w.positions[3 * i],
  w.positions[3 * i + 1],
  w.positions[3 * i + 2],
];

/** The number of samples at or before t, by bisection: 0 before the first, `times.length` from the last one on. */
export const samplesUntil = (times: Float64Array, t: number): number => firstAfter(times.length, (i) => times[i] <= t);

/** The piece between samples i and i + 1. */
export function cubicPiece(w: CubicLine, i: number): CubicPiece {
  const velocity = (k: number): Vec3 => [w.velocities[k], w.velocities[k + 1], w.velocities[k + 2]];
  return {
    a: samplePosition(w, i),
    va: velocity(6 * i),
    b: samplePosition(w, i + 1),
    vb: velocity(6 * i + 3),
    span: w.times[i + 1] - w.times[i],
  };
}

/** The piece in relative form: c = 1, positions relative to `observer`, times in metres of light. c [m/s]. */
export function relativePiece(w: CubicLine, i: number, observer: Vec3, c: number): CubicPiece {
  const { a, va, b, vb, span } = cubicPiece(w, i);
  return { a: sub(a, observer), va: scale(va, 1 / c), b: sub(b, observer), vb: scale(vb, 1 / c), span: c * span };
}

/** By bisection, the first of `count` samples for which `before` is false, given that it is true for all samples before that one; `count` if it is always true. */
export function firstAfter(count: number, before: (sample: number) => boolean): number {
  let [lo, hi] = [0, count];
  while (lo < hi) {
    const mid = (lo + hi) >>> 1;
    if (before(mid)) lo = mid + 1;
    else hi = mid;
  }
  return lo;
}

/** Whether t is before the first sample or not before the last one, where the point is at rest. */
export const restsOutsideSamples = (w: SampledLine, t: number): boolean =>
  t < w.times[0] || t >= w.times[w.times.length - 1];

/** x(t) in the world frame [m]; t: world time [s]; c [m/s] is used only for hyperbolic motion. */
export function positionAt(w: WorldLine, t: number, c: number): Vec3 {
  switch (w.kind) {
    case 'static':
      return w.position;
    case 'uniform':
      return addScaled(w.position, w.velocity, t);
    case 'hyperbolic': {
      // ℓ(√(1 + (at/c)²) − 1) â = at²/(1 + √(1 + (at/c)²)), without cancellation (docs/physics.md §4.4).
      const s = t - w.t0;
      const a = w.properAcceleration;
      return addScaled(w.position, a, (s * s) / (1 + Math.hypot(1, (Math.hypot(...a) * s) / c)));
    }
    case 'circular':
      return add(w.center, rotate(fromAxisAngle(w.axis, w.angularVelocity * t), w.arm));
    case 'polyline':
    case 'cubic':
      return sampledPosition(w, t);
  }
}

function sampledPosition(w: PolylineLine | CubicLine, t: number): Vec3 {
  const i = samplesUntil(w.times, t);
  if (i === 0) return samplePosition(w, 0);
  if (i === w.times.length) return samplePosition(w, i - 1);
  const [t0, t1] = [w.times[i - 1], w.times[i]];
  if (w.kind === 'cubic') return cubicAt(cubicPiece(w, i - 1), t - t0).x;
  return lerp(samplePosition(w, i - 1), samplePosition(w, i), (t - t0) / (t1 - t0));
}

/** dx/dt in the world frame [m/s]. At a sample, the velocity of the piece that starts there. */
export function velocityAt(w: WorldLine, t: number, c: number): Vec3 {
  switch (w.kind) {
    case 'static':
      return ZERO;
    case 'uniform':
      return w.velocity;
    case 'hyperbolic': {
      const s = t - w.t0;
      const a = w.properAcceleration;
      return scale(a, s / Math.hypot(1, (Math.hypot(...a) * s) / c));
    }
    case 'circular': {
      const arm = rotate(fromAxisAngle(w.axis, w.angularVelocity * t), w.arm);
      return scale(cross(w.axis, arm), w.angularVelocity);
    }
    case 'polyline':
    case 'cubic': {
      if (restsOutsideSamples(w, t)) return ZERO;
      const i = samplesUntil(w.times, t);
      if (w.kind === 'cubic') return cubicAt(cubicPiece(w, i - 1), t - w.times[i - 1]).v;
      return scale(sub(samplePosition(w, i), samplePosition(w, i - 1)), 1 / (w.times[i] - w.times[i - 1]));
    }
  }
}

/** The centre of the circle itself, which includes the axial part of the arm, and the arm at t, perpendicular to the axis [m]. */
export function circleAt(w: CircularLine, t: number): { readonly center: Vec3; readonly arm: Vec3 } {
  const turning = addScaled(w.arm, w.axis, -dot(w.arm, w.axis));
  return {
    center: add(w.center, sub(w.arm, turning)),
    arm: rotate(fromAxisAngle(w.axis, w.angularVelocity * t), turning),
  };
}
