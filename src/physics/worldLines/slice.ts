import { fromAxisAngle, rotate } from '../../math/quat.ts';
import { brent } from '../../math/roots.ts';
import { add, addScaled, cross, dot, length, scale, type Vec3 } from '../../math/vec3.ts';
import { gamma } from '../lorentz/boost.ts';

// Events with Δt′ = 0 in the observer's frame, in relative form with c = 1 as in emission.ts. docs/physics.md §5.

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
 * @example
 * uniformSlice([5, 0, 0], 0, [0, 0, 0], [0.75, 0, 0]); // { offset: [5, 0, 0], ahead: 3 } m
 */
export function uniformSlice(d: Vec3, T: number, v: Vec3, u: Vec3): SimultaneousEvent {
  const s = (dot(u, d) - gamma(u) * T) / relativeRate(u, v);
  return { offset: addScaled(d, v, s), ahead: T + s };
}

/**
 * Hyperbolic motion (d, T, a as in `hyperbolicEmission`): ℓ sinh η − β_a ℓ(cosh η − 1) = K, K = T + β·d, β_a = β·â.
 * With e^η = 1 + kφ, K ≥ 0: (1 − β_a) kφ² + 2(1 − kK) φ − 2K = 0, its discriminant the sum of squares
 * (1 − β_a kK)² + (kK)²(1 − β_a²); for K < 0 with η, K, β_a → −η, −K, −β_a. There always is exactly one event. docs/physics.md §5.3.
 * @example
 * // An observer at rest has the world's moments: at its turning point it is where it turns.
 * hyperbolicSlice([0, 0, 4], 0, [0, 0, -0.5], [0, 0, 0]); // { offset: [0, 0, 4], ahead: 0 } m
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

/**
 * Circular motion (arguments as `circularEmission`): the root of s = β·(center + arm(s)) within β·center ± β r. docs/physics.md §5.4.
 * @example
 * circularSlice([5, 0, 0], [0, 0, 1], [0, 0, 0], 0.1, [0.75, 0, 0]); // { offset: [5, 0, 0], ahead: 3 } m
 */
export function circularSlice(center: Vec3, axis: Vec3, arm: Vec3, omega: number, u: Vec3): SimultaneousEvent {
  const beta = scale(u, 1 / gamma(u));
  const offsetAt = (s: number) => add(center, rotate(fromAxisAngle(axis, omega * s), arm));
  const middle = dot(beta, center);
  const reach = length(beta) * length(arm);
  const ahead = brent((s) => s - dot(beta, offsetAt(s)), middle - reach, middle + reach);
  return { offset: offsetAt(ahead), ahead };
}
