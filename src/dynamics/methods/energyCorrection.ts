import { safeguardedNewton } from '../../math/roots.ts';
import { type Message, msg } from '../../messages/message.ts';
import { kineticEnergy } from '../energy.ts';
import type { System } from '../system.ts';
import { StepFailure } from './method.ts';

/**
 * The source documents' remedies for energy that is not conserved. 0: none. 1 and 2: of the velocity change Δv of a step
 * only a fraction is applied, so that the kinetic energy changes by what the potential energy lost: 1 by the tangent of
 * T(v), 2 by its secant, within 0 … 1, which leaves steps as they are that lose energy. 3: the root, which they name as
 * future work: all momenta are multiplied by the factor at which T has the target value (`momentumFactor`).
 */
export type EnergyCorrection = 0 | 1 | 2 | 3;

/** The fraction of Δv. `wanted`: target change of the kinetic energy [J]. */
export function velocityChangeFraction(
  correction: 1 | 2,
  system: System,
  v: Float64Array,
  dv: Float64Array,
  wanted: number,
): number {
  if (correction === 1) return tangentFraction(system, v, dv, wanted);
  const gain = kineticEnergyAt(system, v, dv, 1) - kineticEnergyAt(system, v, dv, 0);
  if (gain <= 0) return 1;
  return wanted <= 0 ? 0 : Math.min(1, wanted / gain);
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

/** Rounding error of a sum of energies, relative to the largest [1]. */
const ENERGY_ROUNDING = 64 * Number.EPSILON;

/**
 * The factor μ ≥ 0 with Σ √(m²c⁴ + μ²p²c²) − mc² = `wanted`. T(μp) rises from 0 without bound, so that there is exactly
 * one where wanted ≥ 0; with r = wanted/T(p) it lies between √r (Newton's mechanics) and r (p ≫ mc), since T is convex
 * in μ and concave in μ². Throws a StepFailure if there is none; `scale`: largest energy that `wanted` is a difference
 * of [J].
 */
export function momentumFactor(system: System, p: Float64Array, wanted: number, scale: number): number {
  const now = kineticEnergy(system, p);
  const rounding = ENERGY_ROUNDING * Math.max(scale, now);
  if (wanted < -rounding)
    throw unconserved(msg`the potential energy alone is ${(-wanted).toPrecision(3)} J above the total`);
  if (now === 0 && wanted > rounding) throw unconserved(msg`nothing moves that could have ${wanted.toPrecision(3)} J`);
  if (now === 0) return 1;
  if (wanted <= 0) return 0;
  const ratio = wanted / now;
  if (system.c === Number.POSITIVE_INFINITY) return Math.sqrt(ratio);
  const [a, b] = [Math.min(ratio, Math.sqrt(ratio)), Math.max(ratio, Math.sqrt(ratio))];
  return safeguardedNewton((factor) => scaledEnergy(system, p, factor, wanted), a, b, Math.sqrt(ratio));
}

const unconserved = (why: Message): StepFailure =>
  new StepFailure('energy', msg`after the step no velocities conserve the energy: ${why}; take a smaller step`);

/** T(μp) − wanted, and its derivative Σ μp²/√(m² + μ²p²/c²). */
function scaledEnergy(
  { c, masses, pinned }: System,
  p: Float64Array,
  factor: number,
  wanted: number,
): readonly [value: number, slope: number] {
  const perSquare = 1 / (c * c);
  let [value, slope] = [-wanted, 0];
  for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
    if (pinned[i]) continue;
    const square = factor * (p[j] * p[j] + p[j + 1] * p[j + 1] + p[j + 2] * p[j + 2]);
    const mass = Math.sqrt(masses[i] * masses[i] + factor * square * perSquare);
    value += (factor * square) / (mass + masses[i]);
    slope += square / mass;
  }
  return [value, slope];
}
