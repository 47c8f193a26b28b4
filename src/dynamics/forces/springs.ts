import { type PairLaw, Pairs } from './pairs.ts';

/** Springs between points: V = Σ ½k(r − L)². They act at once, in the world frame (docs/model.md). */
export interface Springs {
  /** Both ends, spring after spring. */
  readonly ends: Uint32Array;
  /** k of each [N/m] */
  readonly stiffness: Float64Array;
  /** L of each [m] */
  readonly lengths: Float64Array;
}

export const springs = ({ ends, stiffness, lengths }: Springs): Pairs => new Pairs(ends, new Hooke(stiffness, lengths));

class Hooke implements PairLaw {
  private readonly k: Float64Array;
  private readonly L: Float64Array;

  constructor(k: Float64Array, L: Float64Array) {
    this.k = k;
    this.L = L;
  }

  energy = (r: number, s: number): number => 0.5 * this.k[s] * (r - this.L[s]) ** 2;

  slope = (r: number, s: number): number => this.k[s] * (r - this.L[s]);

  curvature = (_: number, s: number): number => this.k[s];

  /** ½k(r₀ + r₁ − 2L)/(r₀ + r₁) */
  quotient = (r0: number, r1: number, s: number): number => (0.5 * this.k[s] * (r0 + r1 - 2 * this.L[s])) / (r0 + r1);

  rigidity = (s: number): number => this.k[s];
}
