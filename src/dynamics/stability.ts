import type { System } from './system.ts';

/**
 * Upper bound of the fastest oscillation [rad/s]: ω² ≤ max_i Σ_j |∂²V/∂x_i∂x_j|/m_i (Gershgorin's circles of M⁻¹∇²V).
 * Moving masses are γm > m, which only slows it down. Explicit methods are stable for h < 2/ω.
 * @example
 * // Two kilograms at a spring of 100 N/m: ω² = 200/s².
 * const spring = { ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(100), lengths: Float64Array.of(1) };
 * const system = makeSystem({ masses: Float64Array.of(1, 1), forces: [springForce(spring)] });
 * maxAngularFrequency(system) ** 2; // 200.0 /s²
 */
export function maxAngularFrequency({ forces, masses, pinned }: System): number {
  const bound = new Float64Array(masses.length);
  for (const force of forces) force.addStiffnessBound(bound);
  return Math.sqrt(bound.reduce((most, k, i) => (pinned[i] ? most : Math.max(most, k / masses[i])), 0));
}
