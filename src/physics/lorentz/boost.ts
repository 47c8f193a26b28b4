import type { Mat4 } from '../../math/mat4.ts';
import { addScaled, cross, dot, length, negate, scale, type Vec3 } from '../../math/vec3.ts';
import { type FourVector, fourVector, spatial } from './fourVector.ts';

// Velocities are given as the proper velocity u = γβ in units of c, which is well conditioned at any speed (docs/physics.md §1.2, §2.1).

/**
 * γ = √(1 + u²) of a proper velocity u = γβ.
 * @example
 * gamma([0, 0, 4 / 3]); // 1.6667
 */
export const gamma = (u: Vec3): number => Math.sqrt(1 + dot(u, u));

/**
 * β = u/γ, in units of c, |β| < 1.
 * @example
 * velocity([0, 0, 4 / 3]); // [0, 0, 0.8] c
 */
export const velocity = (u: Vec3): Vec3 => scale(u, 1 / gamma(u));

/**
 * 1 − β², as (1 − |β|)(1 + |β|).
 * @example
 * oneMinusBetaSquared([0.8, 0, 0]); // 0.36
 */
export function oneMinusBetaSquared(beta: Vec3): number {
  const b = length(beta);
  return (1 - b) * (1 + b);
}

/**
 * u = γβ = β/√(1 − β²) of a velocity in units of c, |β| < 1.
 * @example
 * properVelocity([0, 0.6, 0]); // [0, 0.75, 0] c
 */
export const properVelocity = (beta: Vec3): Vec3 => scale(beta, 1 / Math.sqrt(oneMinusBetaSquared(beta)));

/**
 * The rapidity ζ of a proper velocity: |u| = sinh ζ, γ = cosh ζ, |β| = tanh ζ.
 * @example
 * rapidity([0, 0, 4 / 3]); // 1.0986
 * Math.tanh(rapidity([0, 0, 4 / 3])); // 0.8
 */
export const rapidity = (u: Vec3): number => Math.asinh(length(u));

/**
 * World → the frame that moves with proper velocity u and whose origin meets the world's at ct = 0, without rotation:
 * ct′ = γ ct − u·x,  x′ = x + [u·x/(γ + 1) − ct] u.
 * X [m] in the world frame, the result in the moving frame. docs/physics.md §2.2; Jackson, Classical Electrodynamics, 3rd ed., eq. (11.19).
 * @example
 * // An event 5 m ahead at t = 0, for an observer at 0.6 c: Δx′ = γ Δx, cΔt′ = −γβ Δx.
 * boost([0, 5, 0, 0], properVelocity([0.6, 0, 0])); // [-3.75, 6.25, 0, 0]
 */
export function boost(X: FourVector, u: Vec3): FourVector {
  const g = gamma(u);
  const x = spatial(X);
  const ux = dot(u, x);
  return fourVector(g * X[0] - ux, addScaled(x, u, ux / (g + 1) - X[0]));
}

/**
 * The frame moving with u → world: `boost` with −u.
 * @example
 * const u = properVelocity([0.6, 0, 0]);
 * inverseBoost(boost([2, 5, 0, 1], u), u); // [2, 5, 0, 1]
 */
export const inverseBoost = (X: FourVector, u: Vec3): FourVector => boost(X, negate(u));

/**
 * The matrix of `boost`, row by row, symmetric: X′ = B(u) X. Source: Jackson eq. (11.98).
 * @example
 * boostMatrix([0.75, 0, 0]).slice(0, 4); // [1.25, -0.75, 0, 0]
 */
export function boostMatrix(u: Vec3): Mat4 {
  const g = gamma(u);
  const [x, y, z] = u;
  const k = 1 / (g + 1);
  return [
    ...[g, -x, -y, -z],
    ...[-x, 1 + k * x * x, k * x * y, k * x * z],
    ...[-y, k * y * x, 1 + k * y * y, k * y * z],
    ...[-z, k * z * x, k * z * y, 1 + k * z * z],
  ];
}

/**
 * The spatial part, in the world, of a four-vector (√(m² + x²), x) that is given in the frame moving with u:
 * x + [u·x/(γ + 1) + √(m² + x²)] u, accurate also where the two terms nearly cancel (x points against u).
 * m is the invariant length: 0 for light, 1 for a four-velocity, cΔτ for a displacement along a world line. docs/physics.md §2.3.
 *
 * Along û, with p = x·û, w = |u|: γp + w√(m² + x²) = (w²m² − p² + |u × x|²)/(w√(m² + x²) − γp) where p < 0.
 * @example
 * // A four-velocity of 0.6 c in a frame that moves with 0.8 c: 1.4/1.48 = 0.9459 c in the world.
 * const u = inverseBoostSpatial([0.75, 0, 0], 1, [4 / 3, 0, 0]);
 * velocity(u); // [0.9459, 0, 0]
 */
export function inverseBoostSpatial(x: Vec3, m: number, u: Vec3): Vec3 {
  const g = gamma(u);
  const ux = dot(u, x);
  const e = m === 0 ? length(x) : Math.hypot(m, x[0], x[1], x[2]);
  const w = length(u);
  // For tiny |u| nothing cancels, and its squares could underflow.
  if (ux >= 0 || w < 1e-100) return addScaled(x, u, ux / (g + 1) + e);
  const p = ux / w;
  const side = cross(u, x);
  const along = ((w * m + p) * (w * m - p) + dot(side, side)) / (w * e - g * p);
  return addScaled(x, u, (along - p) / w);
}
