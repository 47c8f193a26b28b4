import { cross, dot, length, negate, normalize, type Vec3 } from '../../math/vec3.ts';
import { mapScalars } from '../../math/vec3Arrays.ts';
import { gamma, oneMinusBetaSquared } from '../lorentz/boost.ts';

// D = ν_observed / ν_emitted throughout: D > 1 is blue.

/**
 * The observer's factor D_o = γ(1 + β·n), n = Δx/|Δx|: D of a source at rest in the world.
 * Δx [any unit of length]: world frame, observer → emission event. u: the observer's γβ. Where u·n < 0 the conjugate form
 * (1 + |u × n|²)/(γ − u·n) is used, accurate at any γ. Δx = 0 has no direction and gives γ.
 * docs/physics.md §3.4; Einstein 1905, §7.
 * @example
 * observerDoppler([0, 0, 1], properVelocity([0, 0, 0.6])); // 2
 * observerDoppler([0, 0, -1], properVelocity([0, 0, 0.6])); // 0.5
 * observerDoppler([1, 0, 0], properVelocity([0, 0, 0.6])); // 1.25: γ, abeam
 */
export function observerDoppler(dx: Vec3, u: Vec3): number {
  const n = normalize(dx);
  const un = dot(u, n);
  if (un >= 0) return gamma(u) + un;
  const side = cross(u, n);
  return (1 + dot(side, side)) / (gamma(u) - un);
}

/**
 * The factor of a moving emitter, D_e = √(1 − β²)/(1 + β·n), for an observer at rest in the world.
 * n: unit, world frame, observer → source at the emission event. β: the emitter's velocity in units of c, world frame.
 * `oneMinusBeta2`: 1 − β², if known to more digits than β gives. docs/physics.md §3.4.
 * @example
 * emitterDoppler([0, 0, 1], [0, 0, -0.6]); // 2: it approaches
 * emitterDoppler([1, 0, 0], [0, 0, 0.6]); // 0.8: 1/γ, abeam
 */
export function emitterDoppler(n: Vec3, beta: Vec3, oneMinusBeta2 = oneMinusBetaSquared(beta)): number {
  const bn = dot(beta, n);
  if (bn >= 0) return Math.sqrt(oneMinusBeta2) / (1 + bn);
  const side = cross(beta, n);
  return (Math.sqrt(oneMinusBeta2) * (1 - bn)) / (oneMinusBeta2 + dot(side, side));
}

/**
 * D = γ_o(1 + β_o·n)/[γ_e(1 + β_e·n)] for any observer and emitter.
 * n: world frame, observer → source at the emission event (any length). Both velocities as γβ, world frame.
 * @example
 * // Of two that move together neither sees a shift.
 * const u = properVelocity([0, 0, 0.6]);
 * dopplerFactor([0, 0, 1], u, u); // 1
 * dopplerFactor([0, 0, 1], [0, 0, 0], u); // 0.5
 */
export const dopplerFactor = (n: Vec3, uObserver: Vec3, uEmitter: Vec3): number =>
  observerDoppler(n, uObserver) / observerDoppler(n, uEmitter);

/**
 * D = 1/[γ(1 − β·n′)] of a source at rest in the world, from its apparent direction.
 * n′: observer's frame, observer → apparent position (any length). u: the observer's γβ. docs/physics.md §3.4.
 * @example
 * dopplerAtPixel([0.6, 0, 0.8], properVelocity([0, 0, 0.8])); // 1.6667: what is abeam is seen with γ
 */
export const dopplerAtPixel = (nPrime: Vec3, u: Vec3): number => 1 / observerDoppler(nPrime, negate(u));

/**
 * `observerDoppler` of many points: 3 numbers in and 1 out per point.
 * @example
 * observerDopplers(new Float64Array([0, 0, 1, 0, 0, -1]), [0, 0, 0.75]); // [2, 0.5]
 */
export const observerDopplers = (dx: Float64Array, u: Vec3, out = new Float64Array(dx.length / 3)): Float64Array =>
  mapScalars(dx, out, (v) => observerDoppler(v, u));

/**
 * `dopplerFactor` of many points for one observer: offsets Δx and emitters' proper velocities, 3 numbers each.
 * @example
 * dopplerFactors(new Float64Array([0, 0, 1]), [0, 0, 0], new Float64Array([0, 0, -0.75])); // [2]
 */
export function dopplerFactors(
  dx: Float64Array,
  uObserver: Vec3,
  uEmitters: Float64Array,
  out = new Float64Array(dx.length / 3),
): Float64Array {
  for (let i = 0, k = 0; k + 2 < dx.length; i++, k += 3)
    out[i] = dopplerFactor([dx[k], dx[k + 1], dx[k + 2]], uObserver, [
      uEmitters[k],
      uEmitters[k + 1],
      uEmitters[k + 2],
    ]);
  return out;
}

/**
 * Apparent transverse speed of a source with velocity β (units of c): |β⊥|/(1 + β·n), in units of c. It exceeds 1 for a source that
 * approaches nearly head-on: β sin θ/(1 − β cos θ), θ the angle between the velocity and the direction to the observer.
 * n: unit, world frame, observer → source. docs/physics.md §3.5; Rees 1966, Nature 211, 468.
 * @example
 * // A jet at 0.99 c, 8.1° from the line towards us: γβ = 7.02 at most, at cos θ = β.
 * const [sin, cos] = [Math.sin(Math.acos(0.99)), 0.99];
 * apparentSpeedAcross([0, 0, 1], [0.99 * sin, 0, -0.99 * cos]); // 7.018 c
 */
export function apparentSpeedAcross(n: Vec3, beta: Vec3): number {
  const bn = dot(beta, n);
  const across = length(cross(beta, n));
  return bn >= 0 ? across / (1 + bn) : (across * (1 - bn)) / (oneMinusBetaSquared(beta) + across * across);
}

/**
 * Apparent radial speed of a source with velocity β (units of c), in units of c, positive for what recedes: β·n/(1 + β·n), the rate at which the light's way
 * grows by the clock of who sees it. It never exceeds 1/2 for what recedes, and exceeds 1 for what approaches faster than c/2.
 * n: unit, observer → source at the emission event; both in one frame. docs/physics.md §3.5.
 * @example
 * apparentRadialSpeed([0, 0, 1], [0, 0, 0.6]); // 0.375
 * apparentRadialSpeed([0, 0, 1], [0, 0, -0.6]); // -1.5 c: superluminal
 */
export function apparentRadialSpeed(n: Vec3, beta: Vec3): number {
  const bn = dot(beta, n);
  const across = cross(beta, n);
  return bn >= 0 ? bn / (1 + bn) : (bn * (1 - bn)) / (oneMinusBetaSquared(beta) + dot(across, across));
}
