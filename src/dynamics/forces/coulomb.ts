import { PairForce, type PairPotential } from './pairs.ts';

/**
 * 1/4πε₀ [N m²/C²], CODATA 2022.
 * @example
 * COULOMB_CONSTANT / 9e9; // 0.9986
 */
export const COULOMB_CONSTANT = 8.987551786e9;

/**
 * Coulomb repulsion or attraction: V = Σ k q_i q_j/r over all pairs, instantaneous as springs are. `strength`: k [N
 * m²/C²].
 * @example
 * // Two charges of 1 μC, 1 m apart.
 * coulomb(Float64Array.of(1e-6, 1e-6)).energy(Float64Array.of(0, 0, 0, 1, 0, 0)); // 0.00899 J
 */
export function coulomb(charges: Float64Array, strength = COULOMB_CONSTANT): PairForce {
  const ends: number[] = [];
  const products: number[] = [];
  for (let i = 0; i < charges.length; i++)
    for (let j = i + 1; j < charges.length; j++) {
      if (charges[i] * charges[j] === 0) continue;
      ends.push(i, j);
      products.push(strength * charges[i] * charges[j]);
    }
  return new PairForce(Uint32Array.from(ends), new CoulombPotential(products));
}

class CoulombPotential implements PairPotential {
  readonly kind = 'inverse-square';
  /** k q q′ [N m²] */
  private readonly k: readonly number[];

  constructor(k: readonly number[]) {
    this.k = k;
  }

  strength = (s: number): number => this.k[s];
  restLength = (): number => 0;
  energy = (r: number, s: number): number => this.k[s] / r;
  derivative = (r: number, s: number): number => -this.k[s] / (r * r);
  secondDerivative = (r: number, s: number): number => (2 * this.k[s]) / (r * r * r);
  /** (1/r₁ − 1/r₀)/(r₁² − r₀²) = −1/(r₀ r₁ (r₀ + r₁)) */
  discreteDerivative = (r0: number, r1: number, s: number): number => -this.k[s] / (r0 * r1 * (r0 + r1));
  /** Unbounded: the stiffness grows as the distance shrinks. */
  maxStiffness = (): number => 0;
}
