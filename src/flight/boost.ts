import { normalizeQuat, type Quat } from '../math/quat.ts';
import { add, addScaled, cross, dot, length, negate, normalize, scale, type Vec3 } from '../math/vec3.ts';

/** A pure boost, which stands for a velocity too: unlike γβ and its squares, it does not overflow. */
export interface Boost {
  /** Of length 1, at rest too. */
  readonly direction: Vec3;
  /** ≥ 0 */
  readonly rapidity: number;
}

/** The boost with a proper velocity γβ in units of c. */
export const boostOf = (u: Vec3): Boost => ({ direction: normalize(u, [1, 0, 0]), rapidity: Math.asinh(length(u)) });

/** γβ = sinh φ n̂ in units of c. */
export const properVelocityOf = ({ direction, rapidity }: Boost): Vec3 => scale(direction, Math.sinh(rapidity));

/** The boost back. */
export const inverse = ({ direction, rapidity }: Boost): Boost => ({ direction: negate(direction), rapidity });

/**
 * How the direction â of a boost lies to a motion n̂: cos²(θ/2) and the part of â across n̂, of length sin θ, both without
 * cancellation near θ = 0 and π.
 */
export function bearing(n: Vec3, a: Vec3): { readonly cosHalfSquared: number; readonly across: Vec3 } {
  const half = scale(add(n, a), 0.5);
  return { cosHalfSquared: dot(half, half), across: cross(n, cross(a, n)) };
}

/**
 * The velocity, in the world, of what moves with `second` in the frame of `first` (axes carried by the pure boost):
 *
 *     sinh²(φ′/2) = sinh²((φ − δ)/2) + sinh φ sinh δ cos²(θ/2)
 *     u′ = [sinh(φ − δ) + 2 cosh φ sinh δ cos²(θ/2)] n̂ + sinh δ (â − (â·n̂) n̂)
 *
 * All terms of the first are positive, so that boosts against each other cancel only in φ − δ. docs/physics.md §2.4 has
 * the same in proper velocities.
 */
export function compose(first: Boost, second: Boost): Boost {
  const [phi, delta] = [first.rapidity, second.rapidity];
  if (phi === 0) return second;
  if (delta === 0) return first;
  const { cosHalfSquared, across } = bearing(first.direction, second.direction);
  const both = Math.sqrt(Math.sinh(phi)) * Math.sqrt(Math.sinh(delta) * cosHalfSquared);
  const rapidity = 2 * Math.asinh(Math.hypot(Math.sinh((phi - delta) / 2), both));
  const along = Math.sinh(phi - delta) + 2 * Math.cosh(phi) * Math.sinh(delta) * cosHalfSquared;
  // Straight on and straight back, the direction stays the same to the last digit.
  if (length(across) === 0) return { direction: along < 0 ? negate(first.direction) : first.direction, rapidity };
  const direction = normalize(addScaled(scale(first.direction, along), across, Math.sinh(delta)), first.direction);
  return { direction, rapidity };
}

/** The velocity of `target` in the frame of `observer`. */
export const relativeBoost = (target: Boost, observer: Boost): Boost => compose(inverse(observer), target);

/**
 * The rotation of gyroscopes relative to the axes carried by the pure boosts, from `first` to compose(first, second): the
 * inverse Wigner rotation, as a quaternion ∝ (sinh(φ/2) sinh(δ/2) â × n̂, cosh((φ − δ)/2) + 2 sinh(φ/2) sinh(δ/2) cos²(θ/2)).
 * docs/physics.md §2.5.
 */
export function gyroscopeRotation(first: Boost, second: Boost): Quat {
  const product = Math.sinh(first.rapidity / 2) * Math.sinh(second.rapidity / 2);
  const [x, y, z] = scale(cross(second.direction, first.direction), product);
  const { cosHalfSquared } = bearing(first.direction, second.direction);
  return normalizeQuat([x, y, z, Math.cosh((first.rapidity - second.rapidity) / 2) + 2 * product * cosHalfSquared]);
}
