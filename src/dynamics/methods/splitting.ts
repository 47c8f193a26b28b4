import type { State } from '../system.ts';
import type { IntegrationMethod, SplittingWork, Stepper } from './method.ts';
import { SplittingRange } from './splittingRange.ts';

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
    begin: (system, work = new SplittingRange(system)) => new SplittingStepper(shares, work),
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
  private readonly shares: readonly number[];
  private readonly work: SplittingWork;

  constructor(shares: readonly number[], work: SplittingWork) {
    this.shares = shares;
    this.work = work;
  }

  step(state: State, h: number): void {
    this.steps(state, h, 1);
  }

  /** Adjacent drifts between two kicks are merged, also of two steps. */
  steps(state: State, h: number, count: number): void {
    const { shares, work } = this;
    const outer = (shares[0] * h) / 2;
    work.drift(state, outer);
    for (let left = count; left > 0; left--)
      shares.forEach((share, k) => {
        const next = k + 1 < shares.length ? (shares[k + 1] * h) / 2 : left > 1 ? outer : 0;
        work.kick(state, share * h, (share * h) / 2 + next);
      });
    state.t += count * h;
  }
}
