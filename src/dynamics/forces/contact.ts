import { PairForce, type PairPotential } from './pairs.ts';

/** How hard spheres are, and where they begin. */
export interface ContactParameters {
  /** Stiffness [N/m]. */
  readonly stiffness: number;
  /** Contact radius relative to the displayed radius. */
  readonly scale: number;
}

/**
 * Values of the source documents (docs/physics.md §14).
 * @example
 * DEFAULT_CONTACT; // { stiffness: 10000, scale: 1.1 }
 */
export const DEFAULT_CONTACT: ContactParameters = { stiffness: 10_000, scale: 1.1 };

/**
 * Repels points nearer than `reach`: φ = ½K(s − r)² for r < s. A soft contact: faster impacts penetrate deeper.
 * @example
 * const soft = new PenaltyPotential(1000, () => 0.5);
 * soft.energy(0.3, 0); // 20 J
 * soft.energy(0.6, 0); // 0 J
 */
export class PenaltyPotential implements PairPotential {
  readonly kind = 'penalty';
  private readonly K: number;
  readonly restLength: (pair: number) => number;

  /** K [N/m]; `reach`: distance s of each pair [m]. */
  constructor(K: number, reach: (pair: number) => number) {
    this.K = K;
    this.restLength = reach;
  }

  strength = (): number => this.K;
  energy = (r: number, pair: number): number => 0.5 * this.K * Math.max(0, this.restLength(pair) - r) ** 2;
  derivative = (r: number, pair: number): number => -this.K * Math.max(0, this.restLength(pair) - r);
  secondDerivative = (r: number, pair: number): number => (r < this.restLength(pair) ? this.K : 0);

  discreteDerivative(r0: number, r1: number, pair: number): number {
    const s = this.restLength(pair);
    if (r0 >= s && r1 >= s) return 0;
    if (r0 < s && r1 < s) return (-0.5 * this.K * (2 * s - r0 - r1)) / (r0 + r1);
    return (this.energy(r1, pair) - this.energy(r0, pair)) / ((r1 - r0) * (r1 + r0));
  }

  maxStiffness = (): number => this.K;
}

/** A rigid sphere: a point of the system, possibly pinned, with a radius. */
export interface ContactSphere {
  /** Its index in the system. */
  readonly point: number;
  /** Displayed radius [m]. */
  readonly radius: number;
}

/**
 * Spheres against points and each other; all pairs, since spheres are few.
 * @example
 * // Two spheres of 1 m, 2.1 m apart: within 1.1 (r₁ + r₂) = 2.2 m they repel.
 * const contact = sphereContacts([{ point: 0, radius: 1 }, { point: 1, radius: 1 }], []);
 * contact.energy(Float64Array.of(0, 0, 0, 2.1, 0, 0)); // 50 J
 */
export function sphereContacts(
  balls: readonly ContactSphere[],
  points: Iterable<number>,
  contact = DEFAULT_CONTACT,
): PairForce {
  const ends: number[] = [];
  const reach: number[] = [];
  const touch = (a: number, b: number, distance: number): void => {
    ends.push(a, b);
    reach.push(contact.scale * distance);
  };
  balls.forEach(({ point, radius }, i) => {
    for (const other of balls.slice(i + 1)) touch(point, other.point, radius + other.radius);
    for (const other of points) touch(point, other, radius);
  });
  return new PairForce(Uint32Array.from(ends), new PenaltyPotential(contact.stiffness, (pair) => reach[pair]));
}
