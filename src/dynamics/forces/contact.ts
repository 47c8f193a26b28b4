import { type PairLaw, Pairs } from './pairs.ts';

export interface Contact {
  /** How hard it pushes [N/m]. */
  readonly stiffness: number;
  /** How much larger than what is shown it is. */
  readonly scale: number;
}

/** Of the source documents. */
export const CONTACT: Contact = { stiffness: 10_000, scale: 1.1 };

/** Pushes points apart that are nearer than `reach`: φ = ½K(s − r)² where r < s, which is soft, so that a hard blow goes in deeper. */
export class Penalty implements PairLaw {
  readonly kind = 'penalty';
  private readonly K: number;
  readonly length: (pair: number) => number;

  /** K [N/m]; `reach`: s of each pair [m]. */
  constructor(K: number, reach: (pair: number) => number) {
    this.K = K;
    this.length = reach;
  }

  strength = (): number => this.K;
  energy = (r: number, pair: number): number => 0.5 * this.K * Math.max(0, this.length(pair) - r) ** 2;
  slope = (r: number, pair: number): number => -this.K * Math.max(0, this.length(pair) - r);
  curvature = (r: number, pair: number): number => (r < this.length(pair) ? this.K : 0);

  quotient(r0: number, r1: number, pair: number): number {
    const s = this.length(pair);
    if (r0 >= s && r1 >= s) return 0;
    if (r0 < s && r1 < s) return (-0.5 * this.K * (2 * s - r0 - r1)) / (r0 + r1);
    return (this.energy(r1, pair) - this.energy(r0, pair)) / ((r1 - r0) * (r1 + r0));
  }

  rigidity = (): number => this.K;
}

/** A rigid ball: a point of the system, which may be pinned, with a radius. */
export interface Ball {
  readonly point: number;
  /** Of what is shown [m]. */
  readonly radius: number;
}

/** Balls against points, and against each other; all pairs, for balls are few. */
export function ballContacts(balls: readonly Ball[], points: Iterable<number>, contact = CONTACT): Pairs {
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
  return new Pairs(Uint32Array.from(ends), new Penalty(contact.stiffness, (pair) => reach[pair]));
}
