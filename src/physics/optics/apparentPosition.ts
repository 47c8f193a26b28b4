import { negate, type Vec3 } from '../../math/vec3.ts';
import { mapVectors } from '../../math/vec3Arrays.ts';
import { inverseBoostSpatial } from '../lorentz/boost.ts';

/**
 * Apparent position Δx′ = Δx + [γ²/(γ + 1) β·Δx + γ|Δx|] β: the spatial part of the past light-cone event (−|Δx|, Δx)
 * in the observer's frame. |Δx′| = D|Δx|, so depth order is preserved along each ray.
 * Δx [m]: world frame, observer → emission event. u: the observer's γβ. The result in the observer's frame [m].
 * Any γ, also in the backward direction; Δx = 0 gives 0. docs/physics.md §3.3: the boost of a null vector.
 * @example
 * // At 0.6 c, what is 3 m ahead appears D = 2 times as far.
 * apparentPosition([0, 0, 3], properVelocity([0, 0, 0.6])); // [0, 0, 6]
 * apparentPosition([0, 0, -3], properVelocity([0, 0, 0.6])); // [0, 0, -1.5]
 */
export const apparentPosition = (dx: Vec3, u: Vec3): Vec3 => inverseBoostSpatial(dx, 0, u);

/**
 * The inverse: observer's frame → world frame, Δx from the apparent position [m].
 * @example
 * inverseApparentPosition([0, 0, 6], properVelocity([0, 0, 0.6])); // [0, 0, 3]
 */
export const inverseApparentPosition = (dxPrime: Vec3, u: Vec3): Vec3 => inverseBoostSpatial(dxPrime, 0, negate(u));

/**
 * `apparentPosition` of many points, 3 numbers each [m]. `out` may be `dx` itself.
 * @example
 * apparentPositions(new Float64Array([0, 0, 3, 0, 0, -3]), [0, 0, 0.75]); // [0, 0, 6, 0, 0, -1.5]
 */
export const apparentPositions = (dx: Float64Array, u: Vec3, out = new Float64Array(dx.length)): Float64Array =>
  mapVectors(dx, out, (v) => apparentPosition(v, u));
