import { fromAxisAngle, rotate } from '../../math/quat.ts';
import { brent } from '../../math/roots.ts';
import { add, addScaled, cross, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { oneMinusBetaSquared } from '../lorentz/boost.ts';

// Emission events in relative form with c = 1: lengths in metres, times in metres of light travel (ct), velocities in units
// of c, everything relative to the observer's event. These functions have twins in shaders/. docs/physics.md §4.

/** An event on the observer's past light cone. */
export interface RetardedEvent {
  /** Δx: observer → emission event, world frame [m]. */
  readonly offset: Vec3;
  /** Light travel time c(t_o − t_e) = |Δx| [m]. */
  readonly delay: number;
}

/**
 * A point at rest. d [m]: observer → point. Also makes the result for any event that is known to lie on the past light cone.
 * @example
 * staticEmission([3, 4, 0]); // { offset: [3, 4, 0], delay: 5 } m
 */
export const staticEmission = (d: Vec3): RetardedEvent => ({ offset: d, delay: length(d) });

/**
 * Uniform motion, at d at the observer's time: the retarded root of |d + v s| = −s,
 * s = [d·v − √((d·v)² + (1 − v²) d²)]/(1 − v²) ≤ 0, in conjugate form where d·v > 0.
 * d [m], v [c]: world frame. `oneMinusV2` = 1 − v² > 0. docs/physics.md §4.2.
 */
export function presentEmission(d: Vec3, v: Vec3, oneMinusV2: number): RetardedEvent {
  const dv = dot(d, v);
  const d2 = dot(d, d);
  const root = Math.sqrt(dv * dv + oneMinusV2 * d2);
  const delay = dv > 0 ? d2 / (dv + root) : (root - dv) / oneMinusV2;
  return { offset: addScaled(d, v, -delay), delay };
}

/**
 * A point at the offset o from an object's centre, both moving with v, from the centre's emission event d_c: as
 * `polylineEmission` with A = d_c + o, T = |d_c|, with q = T² − A² = −(2 d_c·o + o²) free of cancellation.
 * d_c, o [m], v [c]: world frame; `oneMinusV2` = 1 − v² > 0. docs/physics.md §4.2.
 * @example
 * // The centre is seen 5 m away; a point 0.5 m nearer is seen later, and farther along its way.
 * uniformEmission([0, 0, 5], [0.6, 0, 0], 0.64, [0, 0, -0.5]).offset; // [0.294, 0, 4.5]
 */
export function uniformEmission(center: Vec3, v: Vec3, oneMinusV2: number, o: Vec3): RetardedEvent {
  const T = length(center);
  const a = add(center, o);
  const q = -(2 * dot(center, o) + dot(o, o));
  const g = lineOfSightRate(center, T, v, oneMinusV2) + dot(o, v);
  return staticEmission(addScaled(a, v, timeSince(a, T, v, oneMinusV2, q, g) || 0));
}

/**
 * A straight piece from A (time tA) to B (time tB) that crosses the past light cone: A on or inside it, B on or outside it.
 * With T = −tA, the time since A is s = q/(g + √(g² − (1 − v²)q)), q = T² − A², g = T + A·v.
 * The event is clamped to the piece. A, B [m]: observer → sample; tA < tB [m of light]: relative to the observer's time.
 * docs/physics.md §4.3.
 * @example
 * // From 2 m to 8 m in 10 m of light: it is seen where t = −|x|.
 * polylineEmission([2, 0, 0], -9, [8, 0, 0], 1); // { offset: [4.625, 0, 0], delay: 4.625 } m
 */
export function polylineEmission(a: Vec3, tA: number, b: Vec3, tB: number): RetardedEvent {
  const span = tB - tA;
  const v = scale(sub(b, a), 1 / span);
  const [T, r] = [-tA, length(a)];
  const oneMinusV2 = oneMinusBetaSquared(v);
  const g = T - r + lineOfSightRate(a, r, v, oneMinusV2);
  const s = timeSince(a, T, v, oneMinusV2, (T - r) * (T + r), g) || 0;
  return staticEmission(addScaled(a, v, Math.min(span, Math.max(0, s))));
}

/**
 * The retarded root of |A + v s| = T − s. The discriminant g² − (1 − v²)q is computed as ((A + vT)·v)² + (1 − v²)(A + vT)², which
 * keeps its digits where the point passes the observer. A receding point is solved from its position at the observer's time, as in
 * `presentEmission`. NaN if A is the observer's event.
 */
function timeSince(a: Vec3, T: number, v: Vec3, oneMinusV2: number, q: number, g: number): number {
  const now = addScaled(a, v, T);
  const away = dot(now, v);
  const root = Math.sqrt(Math.max(0, away * away + oneMinusV2 * dot(now, now)));
  if (away > 0) return T - dot(now, now) / (away + root);
  return g > 0 ? q / (g + root) : (g - root) / oneMinusV2;
}

/** r(1 + n·v) = r + d·v, without cancellation for approaching points. */
function lineOfSightRate(d: Vec3, r: number, v: Vec3, oneMinusV2: number): number {
  const dv = dot(d, v);
  if (dv >= 0) return r + dv;
  const side = cross(d, v);
  return (oneMinusV2 * r * r + dot(side, side)) / (r - dv);
}

/**
 * Hyperbolic motion x = d + ℓ(cosh η − 1) â, t = −T + ℓ sinh η with ℓ = 1/k, k = |a|: its event on the past light cone of
 * the origin, or undefined behind the horizon, 1 + k(T + ξ) ≤ 0.
 *
 * The quadratic in w = e^η (docs/physics.md §4.4) is written with w = 1 + kφ (emission after the turning point, r ≤ T):
 * (1 + k(ξ − T)) φ² − 2(T + kσ/2) φ − σ = 0, ξ = −d·â, σ = r² − T², whose discriminant is the sum of squares
 * (ξ + kσ/2)² + |d⊥|²; before it with T → −T and 1/w = 1 + kψ. Exact for k → 0 (φ is then the coordinate time since the turning point).
 * d [m]: world frame, observer → turning point. T [m of light]: the observer's time after the turning point.
 * a: proper acceleration over c² [1/m], world frame.
 * @example
 * // It turns 4 m away at this moment, with a/c² = 0.5/m towards the observer, and is seen on its way out.
 * hyperbolicEmission([0, 0, 4], 0, [0, 0, -0.5]); // { offset: [0, 0, 2.6667], delay: 2.6667 } m
 */
export function hyperbolicEmission(d: Vec3, T: number, a: Vec3): RetardedEvent | undefined {
  const k = length(a);
  const r = length(d);
  const xi = k > 0 ? -dot(d, a) / k : 0;
  const sigma = (r - T) * (r + T);
  const across = k > 0 ? length(cross(d, a)) / k : r;
  const root = Math.hypot(xi + (k * sigma) / 2, across);
  const after = r <= T;
  if (!after && 1 + k * (xi + T) <= 0) return undefined;
  const age = after ? T : -T;
  const phi = hyperbolicRoot(age + (k * sigma) / 2, root, sigma, 1 + k * (xi - age), after);
  const grown = 1 + k * phi;
  return staticEmission(addScaled(d, a, (phi * phi) / (2 * grown)));
}

/** The root φ ≥ 0 of lead φ² − 2b φ − σ = 0 that belongs to the past light cone; root = √(b² + lead σ). */
function hyperbolicRoot(b: number, root: number, sigma: number, lead: number, after: boolean): number {
  if (after) return b >= 0 ? -sigma / (b + root) || 0 : (b - root) / lead;
  return b >= 0 ? (b + root) / lead : sigma / (root - b);
}

/**
 * Circular motion: the root of |center + arm(−s)| = s by Brent's method; the distance of the centre gives the bracket. docs/physics.md §4.6.
 * center: observer → centre; arm: centre → point at the observer's time, perpendicular to the axis [m], world frame. omega: ω/c [1/m].
 * @example
 * // From the centre of the circle all of it is seen as long ago as light needs for the radius: a quarter turn here.
 * circularEmission([0, 0, 0], [0, 0, 1], [2, 0, 0], Math.PI / 4); // { offset: [0, -2, 0], delay: 2 } m
 */
export function circularEmission(center: Vec3, axis: Vec3, arm: Vec3, omega: number): RetardedEvent {
  const offsetAt = (s: number) => add(center, rotate(fromAxisAngle(axis, -omega * s), arm));
  const [far, radius] = [length(center), length(arm)];
  const late = (s: number) => s - length(offsetAt(s));
  const delay = brent(late, Math.max(0, far - radius), far + radius);
  return { offset: offsetAt(delay), delay };
}
