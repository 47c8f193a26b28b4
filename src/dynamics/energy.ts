import type { Vec3 } from '../math/vec3.ts';
import type { State, System } from './system.ts';

/**
 * Allowed energy gain relative to the kinetic energy if steps exceed the stability limit; more is not an oscillation.
 */
export const MAX_ENERGY_GAIN = 0.5;

/** Conserved quantities of a state in the world frame; pinned points are excluded. */
export interface ConservedQuantities {
  /** Σ (γ − 1) m c² [J] */
  readonly kinetic: number;
  /** V [J] */
  readonly potential: number;
  /** Their sum [J], without rest energy. */
  readonly total: number;
  /** Σ p [kg m/s] */
  readonly momentum: Vec3;
  /** Σ x × p about the origin [kg m²/s]. */
  readonly angularMomentum: Vec3;
  /** Maximum speed [m/s]. */
  readonly fastest: number;
}

/**
 * Energies, momenta and the greatest speed of a state.
 * @example
 * // One kilogram at 0.6 c, c = 10 m/s: (γ − 1) m c² = 25 J, γ m v = 7.5 kg m/s.
 * const system = makeSystem({ masses: Float64Array.of(1), c: 10 });
 * const state = { ...stateAtRest(new Float64Array(3)), p: momenta(system, [6, 0, 0]) };
 * conservedQuantities(system, state); // { kinetic: 25, potential: 0, momentum: [7.5, 0, 0], fastest: 6 }
 */
export function conservedQuantities(system: System, state: State): ConservedQuantities {
  const { c, masses, pinned } = system;
  const { x, p } = state;
  const momentum: [number, number, number] = [0, 0, 0];
  const angularMomentum: [number, number, number] = [0, 0, 0];
  let fastest = 0;
  for (let j = 0; j < x.length; j += 3) {
    if (pinned[j / 3]) continue;
    const square = p[j] ** 2 + p[j + 1] ** 2 + p[j + 2] ** 2;
    fastest = Math.max(fastest, square / (masses[j / 3] ** 2 + square / (c * c)));
    for (let k = 0; k < 3; k++) {
      const [a, b] = [(k + 1) % 3, (k + 2) % 3];
      momentum[k] += p[j + k];
      angularMomentum[k] += x[j + a] * p[j + b] - x[j + b] * p[j + a];
    }
  }
  const kinetic = kineticEnergy(system, p);
  const potential = potentialEnergy(system, x);
  return { kinetic, potential, total: kinetic + potential, momentum, angularMomentum, fastest: Math.sqrt(fastest) };
}

/** Σ (γ − 1) m c² = Σ p²/(γm + m) [J], which is p²/2m for c = ∞; pinned points are excluded. */
export function kineticEnergy({ c, masses, pinned }: System, p: Float64Array): number {
  const perSquare = 1 / (c * c);
  let sum = 0;
  for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
    if (pinned[i]) continue;
    const square = p[j] * p[j] + p[j + 1] * p[j + 1] + p[j + 2] * p[j + 2];
    sum += square / (Math.sqrt(masses[i] * masses[i] + square * perSquare) + masses[i]);
  }
  return sum;
}

/** V [J] */
export const potentialEnergy = ({ forces }: System, x: Float64Array): number =>
  forces.reduce((sum, force) => sum + force.energy(x), 0);
