import { fromAxisAngle, rotate } from '../../math/quat.ts';
import { brent } from '../../math/roots.ts';
import { add, addScaled, cross, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { mapVectors } from '../../math/vec3Arrays.ts';
import { gamma } from '../lorentz/boost.ts';
import { cubicAt, cubicCrossing } from './cubicPiece.ts';
import type { ObserverEvent } from './lightCone.ts';
import {
  type CubicLine,
  circleAt,
  firstAfter,
  type PolylineLine,
  positionAt,
  relativePiece,
  samplePosition,
  type WorldLine,
} from './worldLine.ts';

// Events with Δt′ = 0 in the observer's frame (docs/physics.md §5). c = 1 in the relative forms, as in emission.ts.

/** An event that is simultaneous with the observer's event in the observer's frame. */
export interface SimultaneousEvent {
  /** Δx: observer → event, world frame [m]. */
  readonly offset: Vec3;
  /** World time relative to the observer's event, c(t − t_o) = β·Δx [m]. */
  readonly ahead: number;
}

/** γ(1 − β·v) = γ − u·v > 0, in conjugate form (1 + u²(1 − v²) + |u × v|²)/(γ + u·v) where u·v > 0. v in units of c. */
function relativeRate(u: Vec3, v: Vec3): number {
  const uv = dot(u, v);
  if (uv <= 0) return gamma(u) - uv;
  const side = cross(u, v);
  const speed = length(v);
  return (1 + dot(u, u) * (1 - speed) * (1 + speed) + dot(side, side)) / (gamma(u) + uv);
}

/**
 * Uniform motion, at d at the world time T relative to the observer's: the event with
 * cΔt = β·Δx is s = (u·d − γT)/(γ − u·v) later. d [m], v [c], u = γβ: world frame; T [m of light].
 * docs/physics.md §5.2.
 */
export function uniformSlice(d: Vec3, T: number, v: Vec3, u: Vec3): SimultaneousEvent {
  const s = (dot(u, d) - gamma(u) * T) / relativeRate(u, v);
  return { offset: addScaled(d, v, s), ahead: T + s };
}

/**
 * Hyperbolic motion (d, T, a as in `hyperbolicEmission`): ℓ sinh η − β_a ℓ(cosh η − 1) = K, K = T + β·d, β_a = β·â.
 * With e^η = 1 + kφ, K ≥ 0: (1 − β_a) kφ² + 2(1 − kK) φ − 2K = 0, its discriminant the sum of squares
 * (1 − β_a kK)² + (kK)²(1 − β_a²); for K < 0 with η, K, β_a → −η, −K, −β_a. There always is exactly one event. docs/physics.md §5.3.
 */
export function hyperbolicSlice(d: Vec3, T: number, a: Vec3, u: Vec3): SimultaneousEvent {
  const g = gamma(u);
  const k = length(a);
  const signed = T + dot(u, d) / g;
  const sign = signed < 0 ? -1 : 1;
  const ahead = Math.abs(signed);
  const along = k > 0 ? (sign * dot(u, a)) / k : 0;
  const side = k > 0 ? length(cross(u, a)) / k : 0;
  // γ²(1 − β_a²) = 1 + u⊥², from which 1 − β_a follows without cancellation.
  const flat = Math.hypot(1, side);
  const lead = along > 0 ? (flat * flat) / (g * (g + along)) : 1 - along / g;
  const K = k * ahead;
  const root = Math.hypot(1 - (along / g) * K, (K * flat) / g);
  const phi = K <= 1 ? (2 * ahead) / (1 - K + root) : (K - 1 + root) / (lead * k);
  const grown = 1 + k * phi;
  return {
    offset: addScaled(d, a, (phi * phi) / (2 * grown)),
    ahead: -T + (sign * phi * (1 + grown)) / (2 * grown),
  };
}

/** Circular motion (arguments as `circularEmission`): the root of s = β·(center + arm(s)) within β·center ± β r. docs/physics.md §5.4. */
export function circularSlice(center: Vec3, axis: Vec3, arm: Vec3, omega: number, u: Vec3): SimultaneousEvent {
  const beta = scale(u, 1 / gamma(u));
  const offsetAt = (s: number) => add(center, rotate(fromAxisAngle(axis, omega * s), arm));
  const middle = dot(beta, center);
  const reach = length(beta) * length(arm);
  const ahead = brent((s) => s - dot(beta, offsetAt(s)), middle - reach, middle + reach);
  return { offset: offsetAt(ahead), ahead };
}

/** The event of `w` with Δt′ = 0 for an observer with proper velocity u at `observer`, in relative form. c [m/s]. docs/physics.md §5.1. */
export function simultaneitySlice(w: WorldLine, observer: ObserverEvent, u: Vec3, c: number): SimultaneousEvent {
  const { t, position } = observer;
  switch (w.kind) {
    case 'static':
      return uniformSlice(sub(w.position, position), 0, [0, 0, 0], u);
    case 'uniform':
      return uniformSlice(sub(positionAt(w, t, c), position), 0, scale(w.velocity, 1 / c), u);
    case 'hyperbolic':
      return hyperbolicSlice(sub(w.position, position), c * (t - w.t0), scale(w.properAcceleration, 1 / (c * c)), u);
    case 'circular': {
      const { center, arm } = circleAt(w, t);
      return circularSlice(sub(center, position), w.axis, arm, w.angularVelocity / c, u);
    }
    case 'polyline':
    case 'cubic':
      return sampledSlice(w, observer, u, c);
  }
}

/** c(t − t_o) − β·Δx increases along the world line, so bisection on its sign at the samples finds the piece. */
function sampledSlice(
  w: PolylineLine | CubicLine,
  { t, position }: ObserverEvent,
  u: Vec3,
  c: number,
): SimultaneousEvent {
  const g = gamma(u);
  const offset = (i: number) => sub(samplePosition(w, i), position);
  const time = (i: number) => c * (w.times[i] - t);
  const after = firstAfter(w.times.length, (i) => g * time(i) - dot(u, offset(i)) <= 0);
  const k = after - 1;
  if (after === 0) return uniformSlice(offset(0), 0, [0, 0, 0], u);
  if (after === w.times.length) return uniformSlice(offset(k), 0, [0, 0, 0], u);
  if (w.kind === 'cubic') {
    const piece = relativePiece(w, k, position, c);
    const s = cubicCrossing(piece, time(k), u);
    return { offset: cubicAt(piece, s).x, ahead: time(k) + s };
  }
  const v = scale(sub(offset(after), offset(k)), 1 / (time(after) - time(k)));
  return uniformSlice(offset(k), time(k), v, u);
}

/**
 * World time [s] of the event of `w` that is simultaneous with the observer's event in the observer's frame:
 * c(t − t_o) = β·(x(t) − x_o). u: the observer's γβ, world frame. c [m/s].
 */
export const simultaneousTime = (w: WorldLine, observer: ObserverEvent, u: Vec3, c: number): number =>
  observer.t + simultaneitySlice(w, observer, u, c).ahead / c;

/** `simultaneousTime` of many world lines [s]. */
export function simultaneousTimes(
  lines: readonly WorldLine[],
  observer: ObserverEvent,
  u: Vec3,
  c: number,
  out = new Float64Array(lines.length),
): Float64Array {
  for (let i = 0; i < lines.length; i++) out[i] = simultaneousTime(lines[i], observer, u, c);
  return out;
}

/**
 * Position of a simultaneous event in the observer's frame: Δx′ = Δx − γ/(γ + 1)(β·Δx)β, for Δx with cΔt = β·Δx.
 * Δx [m]: world frame, observer → event. u: the observer's γβ. docs/physics.md §5.5.
 */
export function simultaneousPosition(dx: Vec3, u: Vec3): Vec3 {
  const g = gamma(u);
  return addScaled(dx, u, -dot(u, dx) / (g * (g + 1)));
}

/** `simultaneousPosition` of many events, 3 numbers each [m]. `out` may be `dx` itself. */
export const simultaneousPositions = (dx: Float64Array, u: Vec3, out = new Float64Array(dx.length)): Float64Array =>
  mapVectors(dx, out, (v) => simultaneousPosition(v, u));

/**
 * Lorentz contraction: the offset between two points of a rigid body at one world time, from the offset in its rest frame.
 * Lengths along u are divided by γ. The same formula as `simultaneousPosition` (docs/physics.md §5.5); not what is seen.
 * offset [m]: rest frame (axes carried by the pure boost) → world frame. u: the body's γβ.
 */
export const contraction = (offset: Vec3, u: Vec3): Vec3 => simultaneousPosition(offset, u);
