import { conjugate, fromAxisAngle, multiply, normalizeQuat, type Quat, rotationAngle } from './quat.ts';
import { normalize, scale, type Vec3 } from './vec3.ts';

// Cubic interpolation between samples that need not be evenly spaced.

/** The slope at a sample: (1 − share) times that of the chord from sample `middle` − 1 to `middle`, plus `share` times that of the next chord. */
export interface SlopeRule {
  readonly middle: number;
  readonly share: number;
}

/** If one of two neighbouring intervals is this many times shorter than the other, it is treated as a jump. */
const MAX_INTERVAL_RATIO = 10;

/**
 * The slope at sample k is that of the parabola through it and its neighbours (non-uniform Catmull–Rom); at the ends, of the parabola through the
 * nearest three. With two samples it is the slope of their chord; beside a jump, that of the longer chord. times: rising, two or more.
 * docs/physics.md §4.8.
 */
export function slopeRule(times: ArrayLike<number>, k: number): SlopeRule {
  const last = times.length - 1;
  if (last < 2) return { middle: 1, share: 0 };
  const middle = Math.min(Math.max(k, 1), last - 1);
  const [before, after] = [times[middle] - times[middle - 1], times[middle + 1] - times[middle]];
  if (before > MAX_INTERVAL_RATIO * after || after > MAX_INTERVAL_RATIO * before) {
    const own = k === middle ? Number(after > before) : Number(k > middle);
    return { middle, share: own };
  }
  const share = k < middle ? -before : k > middle ? before + 2 * after : before;
  return { middle, share: share / (before + after) };
}

/** The cubic from `a` to `b` with the slopes va and vb at its ends, evaluated at the fraction w of `span`. docs/physics.md §4.8. */
export function hermite(a: number, va: number, b: number, vb: number, span: number, w: number): number {
  const chord = (b - a) / span;
  return a + w * span * (va + w * (3 * chord - 2 * va - vb + w * (va + vb - 2 * chord)));
}

/** The rotation vector of a unit quaternion, for the shorter arc [rad]. */
export function logarithm(q: Quat): Vec3 {
  return scale(normalize([q[0], q[1], q[2]]), (q[3] < 0 ? -1 : 1) * rotationAngle(q));
}

const exponential = (v: Vec3): Quat => fromAxisAngle(v, Math.hypot(...v));

/** An orientation and its angular velocity in its own axes [rad per unit of time]. */
export interface AngularState {
  readonly orientation: Quat;
  readonly rate: Vec3;
}

/**
 * The orientation at the fraction w of `span` between two orientations with given angular velocities: the rotations between the control
 * orientations of a Bézier curve, each scaled by its cumulative Bernstein polynomial. Source: Kim, Kim and Shin, SIGGRAPH 1995.
 */
export function hermiteRotation(a: AngularState, b: AngularState, span: number, w: number): Quat {
  const first = scale(a.rate, span / 3);
  const last = scale(b.rate, span / 3);
  const inner = multiply(a.orientation, exponential(first));
  const between = logarithm(multiply(multiply(conjugate(inner), b.orientation), exponential(scale(last, -1))));
  const turns = [
    exponential(scale(first, 1 - (1 - w) ** 3)),
    exponential(scale(between, w * w * (3 - 2 * w))),
    exponential(scale(last, w ** 3)),
  ];
  return normalizeQuat(turns.reduce(multiply, a.orientation));
}
