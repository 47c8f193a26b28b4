import { cross, dot, length, negate, normalize, type Vec3 } from '../../math/vec3.ts';
import { inverseBoostSpatial } from '../lorentz/boost.ts';

/**
 * Aberration: n′ = [n + (γ + γ²/(γ + 1) β·n) β]/[γ(1 + β·n)]. Directions are concentrated towards the direction of motion.
 * n: unit, world frame, observer → source. u: the observer's γβ. n′: unit, observer's frame. n = 0 gives 0.
 * docs/physics.md §3.2; Jackson eq. (11.32) as a vector.
 * @example
 * // At 0.8 c, what is abeam is seen 36.87° from straight ahead: cos θ′ = β.
 * aberrate([1, 0, 0], properVelocity([0, 0, 0.8])); // [0.6, 0, 0.8]
 */
export const aberrate = (n: Vec3, u: Vec3): Vec3 => normalize(inverseBoostSpatial(n, 0, u));

/**
 * The inverse of `aberrate`: observer's frame → world frame.
 * @example
 * unaberrate([0.6, 0, 0.8], properVelocity([0, 0, 0.8])); // [1, 0, 0]
 */
export const unaberrate = (nPrime: Vec3, u: Vec3): Vec3 => normalize(inverseBoostSpatial(nPrime, 0, negate(u)));

/**
 * Terrell–Penrose rotation: the angle by which a small body appears turned, between the direction in which it is seen and that from which its light
 * leaves it in its rest frame [rad]. arcsin β for what is seen at right angles to its motion. n: unit, observer → source, u: the source's γβ, both in the
 * observer's frame. docs/physics.md §3.8; Terrell 1959, Phys. Rev. 116, 1041.
 * @example
 * terrellRotation([1, 0, 0], properVelocity([0, 0, 0.6])); // 0.6435: arcsin 0.6
 * terrellRotation([0, 0, 1], properVelocity([0, 0, 0.6])); // 0: what recedes straight away is not turned
 */
export function terrellRotation(n: Vec3, u: Vec3): number {
  const inRestFrame = aberrate(n, u);
  return Math.atan2(length(cross(n, inRestFrame)), dot(n, inRestFrame));
}
