import { normalizeQuat, type Quat } from '../../math/quat.ts';
import { cross, dot, negate, type Vec3 } from '../../math/vec3.ts';
import { gamma, inverseBoostSpatial } from './boost.ts';

/**
 * Velocity addition u ⊕ u₂, with `u2` measured in the frame that moves with u (axes carried by the pure boost):
 * u₂ + [u·u₂/(γ + 1) + γ₂] u. Proper velocities γβ in units of c; the result in the world frame. Neither commutative nor
 * associative: see `wignerRotation`. docs/physics.md §2.4; Jackson §11.4, as a boost of the four-velocity.
 * @example
 * // 0.5 c and 0.5 c make 0.8 c.
 * const u = properVelocity([0.5, 0, 0]);
 * velocity(addVelocities(u, u)); // [0.8, 0, 0]
 */
export const addVelocities = (u: Vec3, u2: Vec3): Vec3 => inverseBoostSpatial(u2, 1, u);

/**
 * The proper velocity, in the observer's frame, of something with proper velocity u; both u and `uObserver` in the world frame.
 * @example
 * // Two rockets at 0.5 c towards each other.
 * const u = properVelocity([0.5, 0, 0]);
 * velocity(relativeVelocity([-u[0], 0, 0], u)); // [-0.8, 0, 0]
 */
export const relativeVelocity = (u: Vec3, uObserver: Vec3): Vec3 => inverseBoostSpatial(u, 1, negate(uObserver));

/**
 * The rotation R in B(u₂)B(u₁) = R·B(u₁ ⊕ u₂): it relates the axes after two boosts to those after the single boost. A vector with the
 * coordinates v in the axes of B(u₁ ⊕ u₂) has the coordinates R v in those of B(u₂)B(u₁). docs/physics.md §2.5.
 *
 * As a quaternion ∝ (s₁ × s₂, C₁C₂ + s₁·s₂) with C = cosh(ζ/2) = √((γ + 1)/2), s = sinh(ζ/2) û = u/(2C), so that
 * tan(θ/2) = |s₁ × s₂|/(C₁C₂ + s₁·s₂). Source: product of the spinor matrices C − s·σ; Ungar 1988, Found. Phys. Lett. 1, 57.
 * @example
 * // Two boosts of 0.8 c at right angles: tan θ = −γ²β²/(2γ), θ = −28.07°.
 * import { quat } from 'slowlight/math';
 * const r = wignerRotation([4 / 3, 0, 0], [0, 4 / 3, 0]);
 * (quat.rotationAngle(r) * 180) / Math.PI; // 28.07°
 */
export function wignerRotation(u1: Vec3, u2: Vec3): Quat {
  const c1 = Math.sqrt((gamma(u1) + 1) / 2);
  const c2 = Math.sqrt((gamma(u2) + 1) / 2);
  const scaleBoth = 1 / (4 * c1 * c2);
  const ss = dot(u1, u2) * scaleBoth;
  const [x, y, z] = cross(u1, u2);
  const sideSquare = (x * x + y * y + z * z) * scaleBoth * scaleBoth;
  // (C₁C₂)² − (s₁·s₂)² = 1 + s₁² + s₂² + |s₁ × s₂|² avoids cancellation for opposite boosts.
  const real = ss >= 0 ? c1 * c2 + ss : (c1 * c1 + c2 * c2 - 1 + sideSquare) / (c1 * c2 - ss);
  return normalizeQuat([x * scaleBoth, y * scaleBoth, z * scaleBoth, real]);
}

/**
 * Four-acceleration A^μ = (γ⁴ β·a, γ² a + γ⁴(β·a) β) as [A⁰, A] for a coordinate acceleration a = dv/dt, with U^μA_μ = 0.
 * β in units of c, world frame; A in the unit of a [m/s²]. docs/physics.md §2.6; Jackson §11.7.
 * @example
 * // At 0.6 c, 1 m/s² along the velocity: γ⁴β = 1.46, γ⁴ = 2.44.
 * fourAcceleration([0.75, 0, 0], [1, 0, 0]); // [1.46484, 2.44141, 0, 0]
 */
export function fourAcceleration(u: Vec3, a: Vec3): readonly [number, number, number, number] {
  const g2 = 1 + dot(u, u);
  const ua = dot(u, a);
  const g = Math.sqrt(g2);
  return [g2 * g * ua, g2 * (a[0] + ua * u[0]), g2 * (a[1] + ua * u[1]), g2 * (a[2] + ua * u[2])];
}
