import { brent } from '../../math/roots.ts';
import { addScaled, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { gamma, properVelocity, velocity } from '../lorentz/boost.ts';
import { apparentPosition } from '../optics/apparentPosition.ts';
import type { ObserverEvent } from './kinds/worldLineKind.ts';
import { pastLightCone } from './lightCone.ts';
import type { Hypersurface } from './lightSurfaces.ts';
import { firstAfter, type SampledLine, samplePosition } from './samples.ts';
import { simultaneitySlice } from './simultaneity.ts';
import type { SimultaneousEvent } from './slice.ts';
import { asInertial, asPolyline, positionAt, type WorldLine } from './worldLine.ts';

// The cone ct′ = −λr′ of the observer's frame, between the slice (λ = 0) and the past light cone (λ = 1). docs/physics.md §5.8.

/**
 * γβ of an observer whose velocity is λ times that of u. With ct′ in units of λ, the cone ct′ = −λr′ is the past light cone of a world in which all
 * velocities of the observer's frame are λ times as large; in it the world's frame has this velocity. docs/physics.md §5.8.
 */
export const slowed = (u: Vec3, slope: number): Vec3 => properVelocity(scale(velocity(u), slope));

/**
 * Factor k of Y = Δx − k u (u·Δx), the place in the slowed world's rest frame of what is at Δx in the world: lengths along u are multiplied by γ_λ/γ, those of
 * the slice (1/γ) without the contraction by the slowed velocity.
 */
export function slowedContraction(u: Vec3, slope: number): number {
  const u2 = dot(u, u);
  return u2 > 0 ? (1 - gamma(slowed(u, slope)) / gamma(u)) / u2 : 0;
}

/** Y. */
export const slowedPlace = (dx: Vec3, u: Vec3, slope: number): Vec3 =>
  addScaled(dx, u, -slowedContraction(u, slope) * dot(u, dx));

/**
 * Observer-frame position Δx′ of the event at Δx on the cone ct′ = −λr′: the apparent position in the slowed world. λ = 0: `simultaneousPosition`;
 * λ = 1: `apparentPosition`. Δx [m]: world frame, observer → event; u: the observer's γβ. docs/physics.md §5.8.
 * @example
 * // At 0.6 c, what rests 5 m ahead: 4 m ahead now, 10 m ahead as it is seen, and between.
 * shallowPosition([5, 0, 0], [0.75, 0, 0], 0.5); // [5.714, 0, 0] m
 */
export const shallowPosition = (dx: Vec3, u: Vec3, slope: number): Vec3 =>
  apparentPosition(slowedPlace(dx, u, slope), slowed(u, slope));

/**
 * Time [m of light] that a point with velocity v [c] takes from its place a at the time T before the observer's to the cone: the smaller root of
 * −Ms² + 2gs − q = 0, with τ = ct′ at a, b = γ(1 − β·v), μ = 1 − λ²: q = λ²(T² − a²) + μτ², g = λ²(T + a·v) − μbτ, M = λ²(1 − v²) + μb². The discriminant
 * g² − Mq is λ²(M S² + λ²(S·q′)²), S the place in the slice and q′ = dx′/dct, a sum of squares. docs/physics.md §5.8.
 */
function crossingTime(slope: number, T: number, a: Vec3, v: Vec3, u: Vec3, g: number): number {
  const [square, mu] = [slope * slope, (1 - slope) * (1 + slope)];
  const b = g - dot(u, v);
  const tau = -g * T - dot(u, a);
  const M = square * (1 - dot(v, v)) + mu * b * b;
  const q = square * (T * T - dot(a, a)) + mu * tau * tau;
  const half = square * (T + dot(a, v)) - mu * b * tau;
  const e = addScaled(a, v, -tau / b);
  const S = addScaled(e, u, -dot(u, e) / (g * (g + 1)));
  const Sq = dot(S, inObserverFrame(1, v, u, g));
  const root = slope * Math.sqrt(M * dot(S, S) + square * Sq * Sq);
  return half > 0 ? q / (half + root) : (half - root) / M;
}

/** The spatial part of a displacement (t, x) in the observer's frame, as `boost`; `g`: γ of u. */
const inObserverFrame = (t: number, x: Vec3, u: Vec3, g: number): Vec3 => addScaled(x, u, dot(u, x) / (g + 1) - t);

/** ct′ + λr′ of the event (t, x) relative to the observer. */
const lateness = (slope: number, x: Vec3, t: number, u: Vec3, g: number): number =>
  g * t - dot(u, x) + slope * length(inObserverFrame(t, x, u, g));

/** The crossing of a line that is straight between samples, and at rest outside them. */
function onPolyline(
  slope: number,
  w: SampledLine,
  { t, position }: ObserverEvent,
  u: Vec3,
  c: number,
): SimultaneousEvent {
  const g = gamma(u);
  const place = (k: number) => sub(samplePosition(w, k), position);
  const time = (k: number) => c * (w.times[k] - t);
  const last = w.times.length - 1;
  const after = firstAfter(w.times.length, (k) => lateness(slope, place(k), time(k), u, g) <= 0);
  const k = Math.min(Math.max(0, after - 1), last);
  const rests = after === 0 || after > last;
  const v: Vec3 = rests ? [0, 0, 0] : scale(sub(place(k + 1), place(k)), 1 / (time(k + 1) - time(k)));
  const s = crossingTime(slope, -time(k), place(k), v, u, g);
  return { offset: addScaled(place(k), v, s), ahead: time(k) + s };
}

/** The crossing of any line, which lies between its events on the past light cone and on the slice. */
function onAnyLine(slope: number, line: WorldLine, observer: ObserverEvent, u: Vec3, c: number): SimultaneousEvent {
  const { t, position } = observer;
  const g = gamma(u);
  const offsetAt = (ahead: number) => sub(positionAt(line, t + ahead / c, c), position);
  const late = (ahead: number) => lateness(slope, offsetAt(ahead), ahead, u, g);
  const last = simultaneitySlice(line, observer, u, c).ahead;
  const seen = pastLightCone(line, observer, c);
  let first = seen ? -seen.delay : last - 1;
  // Behind a horizon, where the line comes from the infinite past at less than λ of its distance.
  for (let step = 1; !seen && late(first) > 0; step *= 2) first -= step;
  const ahead = first < last ? brent(late, first, last) : last;
  return { offset: offsetAt(ahead), ahead };
}

/** ct′ = −λr′ in the observer's frame, 0 < λ = `slope` < 1. docs/physics.md §5.8. */
export const shallowCone = (slope: number): Hypersurface => ({
  isLightCone: false,
  lightSurface: 'slice',
  momentVelocity: (u) => u,
  intersect(line, observer, u, c) {
    const inertial = asInertial(line);
    if (inertial) {
      const place = sub(addScaled(inertial.position, inertial.velocity, observer.t), observer.position);
      const v = scale(inertial.velocity, 1 / c);
      const s = crossingTime(slope, 0, place, v, u, gamma(u));
      return { offset: addScaled(place, v, s), ahead: s };
    }
    const samples = asPolyline(line);
    return samples ? onPolyline(slope, samples, observer, u, c) : onAnyLine(slope, line, observer, u, c);
  },
  // Relative velocities add: the slowed light, λ, against the observer's β.
  steepness(u) {
    const beta = length(velocity(u));
    return (beta + slope) / (1 + beta * slope);
  },
  timeAt(dx, u) {
    const away = length(shallowPosition(dx, u, slope));
    return (dot(u, dx) - slope * away) / gamma(u);
  },
  lateness: (x, y, z, t, u, g) => lateness(slope, [x, y, z], t, u, g),
  latenessRate(x, y, z, t, vx, vy, vz, u, g) {
    const place = inObserverFrame(t, [x, y, z], u, g);
    const away = length(place);
    const v: Vec3 = [vx, vy, vz];
    const recession = dot(place, inObserverFrame(1, v, u, g));
    return g - dot(u, v) + (away > 0 ? (slope * recession) / away : 0);
  },
  crossingTime: (T, ax, ay, az, vx, vy, vz, u, g) => crossingTime(slope, T, [ax, ay, az], [vx, vy, vz], u, g),
});
