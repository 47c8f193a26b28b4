import { brent } from '../../math/roots.ts';
import type { System } from '../system.ts';

/**
 * The source documents' remedy for growing energy: of the velocity change Δv of a step only a fraction is applied, so
 * that the kinetic energy changes by what the potential energy lost. 0: off; 1: fraction by the tangent of T(v); 2: by
 * its secant, within 0 … 1; 3: the fraction at which T has the target value, bracketed by these two and not negative,
 * which they name as future work.
 */
export type EnergyCorrection = 0 | 1 | 2 | 3;

/** The fraction of Δv. `wanted`: target change of the kinetic energy [J]. */
export function velocityChangeFraction(
  correction: EnergyCorrection,
  system: System,
  v: Float64Array,
  dv: Float64Array,
  wanted: number,
): number {
  if (correction === 0) return 1;
  if (correction === 1) return tangentFraction(system, v, dv, wanted);
  const before = kineticEnergyAt(system, v, dv, 0);
  const gain = kineticEnergyAt(system, v, dv, 1) - before;
  const secant = secantFraction(gain, wanted);
  if (correction === 2 || gain <= 0 || wanted <= 0) return secant;
  const tangent = Math.max(0, tangentFraction(system, v, dv, wanted));
  const off = (share: number): number => kineticEnergyAt(system, v, dv, share) - before - wanted;
  return brent(off, Math.min(secant, tangent), Math.max(secant, tangent), 1e-12);
}

/** ΔT = Σ γ³ m v·Δv; the fraction is clamped to −1 … 1. */
function tangentFraction(system: System, v: Float64Array, dv: Float64Array, wanted: number): number {
  const { c, masses } = system;
  let slope = 0;
  for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
    const square = v[j] * v[j] + v[j + 1] * v[j + 1] + v[j + 2] * v[j + 2];
    const work = v[j] * dv[j] + v[j + 1] * dv[j + 1] + v[j + 2] * dv[j + 2];
    slope += masses[i] * (1 - square / (c * c)) ** -1.5 * work;
  }
  return slope === 0 ? 1 : Math.min(1, Math.max(-1, wanted / slope));
}

function secantFraction(gain: number, wanted: number): number {
  if (gain <= 0) return 1;
  return wanted <= 0 ? 0 : Math.min(1, wanted / gain);
}

/** Σ (γ − 1) m c² at v + share·Δv [J]; infinite if not below c. */
function kineticEnergyAt({ c, masses }: System, v: Float64Array, dv: Float64Array, share: number): number {
  let sum = 0;
  for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
    const [x, y, z] = [v[j] + share * dv[j], v[j + 1] + share * dv[j + 1], v[j + 2] + share * dv[j + 2]];
    const square = x * x + y * y + z * z;
    const rest = 1 - square / (c * c);
    if (!(rest > 0)) return Number.POSITIVE_INFINITY;
    const gamma = 1 / Math.sqrt(rest);
    // (γ − 1) c² = γ² v²/(γ + 1)
    sum += (masses[i] * gamma * gamma * square) / (gamma + 1);
  }
  return sum;
}
