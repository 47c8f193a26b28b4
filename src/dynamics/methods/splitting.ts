import { movingMasses, type State, type System } from '../system.ts';
import { forceAt, type Method, type Stepper } from './method.ts';

/**
 * H = Σ√(p²c² + m²c⁴) + V(x) is a part of p and a part of x, each of which is followed exactly in turn: x goes on at constant p for half a step, p is pushed at
 * constant x, x goes on. Symplectic and reversible; the energy swings, and has no trend. Steps of several lengths in a symmetric row cancel the errors of lower orders.
 * `row`: their shares of h before the middle one. Sources: Yoshida 1990, Phys. Lett. A 150, 262; Suzuki and Umeno 1993; Hairer, Lubich, Wanner, §V.3.2.
 */
const splitting = (id: string, order: number, row: readonly number[]): Method => {
  const middle = 1 - 2 * row.reduce((sum, share) => sum + share, 0);
  const shares = [...row, middle, ...row.toReversed()];
  return { id, order, bounded: true, begin: (system) => new Splitting(system, shares) };
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

class Splitting implements Stepper {
  private readonly system: System;
  private readonly shares: readonly number[];
  private readonly force: Float64Array;
  private readonly M: Float64Array;

  constructor(system: System, shares: readonly number[]) {
    this.system = system;
    this.shares = shares;
    this.force = new Float64Array(3 * system.masses.length);
    this.M = new Float64Array(system.masses.length);
  }

  step(state: State, h: number): void {
    for (const share of this.shares) {
      this.drift(state, (share * h) / 2);
      forceAt(this.system, state.x, this.force);
      this.kick(state, (share * h) / 2);
      this.turn(state, share * h);
      this.kick(state, (share * h) / 2);
      this.drift(state, (share * h) / 2);
    }
    state.t += h;
  }

  /** x += h p/γm */
  private drift({ x, p }: State, h: number): void {
    const { system, M } = this;
    movingMasses(system, p, M);
    for (let i = 0, j = 0; i < M.length; i++, j += 3) {
      const s = h / M[i];
      x[j] += s * p[j];
      x[j + 1] += s * p[j + 1];
      x[j + 2] += s * p[j + 2];
    }
  }

  private kick({ p }: State, h: number): void {
    const { force } = this;
    const { pinned } = this.system;
    for (let i = 0, j = 0; i < pinned.length; i++, j += 3) {
      if (pinned[i]) continue;
      p[j] += h * force[j];
      p[j + 1] += h * force[j + 1];
      p[j + 2] += h * force[j + 2];
    }
  }

  /** dp/dt = q p × B/γm turns p about −B by q|B|h/γm, exactly. */
  private turn({ p }: State, h: number): void {
    const { charges, magneticField: B, pinned } = this.system;
    if (!charges || !B) return;
    const strength = Math.hypot(...B);
    if (strength === 0) return;
    const [bx, by, bz] = B.map((value) => value / strength);
    movingMasses(this.system, p, this.M);
    for (let i = 0, j = 0; i < charges.length; i++, j += 3) {
      if (pinned[i] || charges[i] === 0) continue;
      const angle = (-charges[i] * strength * h) / this.M[i];
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const [x, y, z] = [p[j], p[j + 1], p[j + 2]];
      const along = (1 - c) * (x * bx + y * by + z * bz);
      p[j] = c * x + s * (by * z - bz * y) + along * bx;
      p[j + 1] = c * y + s * (bz * x - bx * z) + along * by;
      p[j + 2] = c * z + s * (bx * y - by * x) + along * bz;
    }
  }
}
