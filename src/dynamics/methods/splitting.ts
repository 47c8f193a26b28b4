import type { Vec3 } from '../../math/vec3.ts';
import type { State, System } from '../system.ts';
import { type IntegrationMethod, potentialForces, type Stepper } from './method.ts';

/**
 * H = Σ√(p²c² + m²c⁴) + V(x) splits into a part of p and a part of x, each integrated exactly in turn: x drifts at
 * constant p for half a step, p is kicked at constant x, x drifts. Symplectic and time-reversible; the energy error
 * oscillates without a trend. Symmetric compositions of steps of several lengths cancel the errors of lower orders.
 * `row`: their fractions of h before the middle one. Sources: Yoshida 1990, Phys. Lett. A 150, 262; Suzuki and Umeno
 * 1993; Hairer, Lubich, Wanner, §V.3.2.
 */
const splitting = (id: string, order: number, coefficients: readonly number[]): IntegrationMethod => {
  const middle = 1 - 2 * coefficients.reduce((sum, share) => sum + share, 0);
  const shares = [...coefficients, middle, ...coefficients.toReversed()];
  return {
    id,
    order,
    conditionallyStable: true,
    coefficients: shares,
    begin: (system) => new SplittingStepper(system, shares),
  };
};

export const leapfrog = splitting('leapfrog', 2, []);
export const yoshida4 = splitting('yoshida-4', 4, [1 / (2 - Math.cbrt(2))]);
export const yoshida6 = splitting('yoshida-6', 6, [0.7845136104775573, 0.23557321335935813, -1.177679984178871]);
export const yoshida8 = splitting(
  'yoshida-8',
  8,
  [
    0.741670364350613, -0.4091008258000316, 0.1907547102962384, -0.5738624711160822, 0.2990641813036559,
    0.3346249182452982, 0.3152930923967666,
  ],
);

class SplittingStepper implements Stepper {
  private readonly system: System;
  private readonly shares: readonly number[];
  private readonly force: Float64Array;

  constructor(system: System, shares: readonly number[]) {
    this.system = system;
    this.shares = shares;
    this.force = new Float64Array(3 * system.masses.length);
  }

  /** Adjacent drifts between two kicks are merged. */
  step(state: State, h: number): void {
    const { system, shares, force } = this;
    this.drift(state, (shares[0] * h) / 2);
    shares.forEach((share, k) => {
      potentialForces(system, state.x, force);
      this.kick(state, share * h);
      this.drift(state, ((share + (shares[k + 1] ?? 0)) * h) / 2);
    });
    state.t += h;
  }

  /** x += h p/γm */
  private drift({ x, p }: State, h: number): void {
    const { c, masses } = this.system;
    const perSquare = 1 / (c * c);
    for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
      const px = p[j];
      const py = p[j + 1];
      const pz = p[j + 2];
      const s = h / Math.sqrt(masses[i] * masses[i] + (px * px + py * py + pz * pz) * perSquare);
      x[j] += s * px;
      x[j + 1] += s * py;
      x[j + 2] += s * pz;
    }
  }

  /** p += h F at constant x; with a magnetic field in two halves, before and after p rotates. */
  private kick(state: State, h: number): void {
    const { charges, magneticField } = this.system;
    if (!charges || !magneticField) {
      this.applyForce(state, h);
      return;
    }
    this.applyForce(state, h / 2);
    this.rotateMomenta(state, h, charges, magneticField);
    this.applyForce(state, h / 2);
  }

  private applyForce({ p }: State, h: number): void {
    const { force } = this;
    const { pinned } = this.system;
    for (let i = 0, j = 0; i < pinned.length; i++, j += 3) {
      if (pinned[i]) continue;
      p[j] += h * force[j];
      p[j + 1] += h * force[j + 1];
      p[j + 2] += h * force[j + 2];
    }
  }

  /** dp/dt = q p × B/γm rotates p about −B by q|B|h/γm, exactly. */
  private rotateMomenta({ p }: State, h: number, charges: Float64Array, B: Vec3): void {
    const { c: light, masses, pinned } = this.system;
    const strength = Math.hypot(...B);
    if (strength === 0) return;
    const [bx, by, bz] = B.map((value) => value / strength);
    for (let i = 0, j = 0; i < charges.length; i++, j += 3) {
      if (pinned[i] || charges[i] === 0) continue;
      const [x, y, z] = [p[j], p[j + 1], p[j + 2]];
      const M = Math.sqrt(masses[i] * masses[i] + (x * x + y * y + z * z) / (light * light));
      const angle = (-charges[i] * strength * h) / M;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const along = (1 - c) * (x * bx + y * by + z * bz);
      p[j] = c * x + s * (by * z - bz * y) + along * bx;
      p[j + 1] = c * y + s * (bz * x - bx * z) + along * by;
      p[j + 2] = c * z + s * (bx * y - by * x) + along * bz;
    }
  }
}
