import { describe, expect, it } from 'vitest';
import { springForce } from './forces/springs.ts';
import { Integrator } from './integrator.ts';
import { METHODS } from './methods/library.ts';
import { makeSystem, momenta } from './system.ts';

const [C, K, DRAG, TIME] = [1, 4, 0.7, 1];
const START = [1, 0, 0.1, 0.3] as const;

/**
 * Position and momentum of a mass on a spring with drag, by dx/dt = p/√(1 + p²/c²), dp/dt = −Kx − drag p, with
 * Runge–Kutta steps, independent of the tested code.
 */
function exact(steps: number): readonly number[] {
  const h = TIME / steps;
  const slope = ([x, y, p, q]: readonly number[]): number[] => {
    const gamma = Math.sqrt(1 + (p * p + q * q) / (C * C));
    return [p / gamma, q / gamma, -K * x - DRAG * p, -K * y - DRAG * q];
  };
  const plus = (a: readonly number[], b: readonly number[], s: number): number[] => a.map((each, i) => each + s * b[i]);
  let state: readonly number[] = START;
  for (let i = 0; i < steps; i++) {
    const a = slope(state);
    const b = slope(plus(state, a, h / 2));
    const c = slope(plus(state, b, h / 2));
    const d = slope(plus(state, c, h));
    state = state.map((each, k) => each + (h / 6) * (a[k] + 2 * b[k] + 2 * c[k] + d[k]));
  }
  return state;
}

/** Error of a method's result. */
function error(id: string, steps: number, end: readonly number[]): number {
  const net = { ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(K), lengths: Float64Array.of(0) };
  const masses = Float64Array.of(1, 1);
  const system = makeSystem({ masses, pinned: Uint8Array.of(1, 0), c: C, drag: DRAG, forces: [springForce(net)] });
  const [x, y, p, q] = START;
  const gamma = Math.hypot(1, p, q);
  const state = { t: 0, x: Float64Array.of(0, 0, 0, x, y, 0), p: momenta(system, [0, 0, 0, p / gamma, q / gamma, 0]) };
  const mover = new Integrator(system, METHODS.get(id)!);
  for (let i = 0; i < steps; i++) mover.step(state, TIME / steps);
  expect(state.t).toBeCloseTo(TIME, 12);
  return Math.hypot(state.x[3] - end[0], state.x[4] - end[1], state.p[3] - end[2], state.p[4] - end[3]);
}

describe('in air', () => {
  const end = exact(4000);

  it.each([
    ['leapfrog', 20],
    ['yoshida-4', 20],
    ['yoshida-6', 8],
    ['yoshida-8', 6],
    ['discrete-gradient', 20],
    ['implicit-midpoint', 20],
    ['semi-implicit-euler-0', 400],
    ['linearly-implicit-2', 400],
  ])('a step of %s has the stated order', (id, steps) => {
    const { order } = METHODS.get(id)!;
    const gain = Math.log2(error(id, steps, end) / error(id, 2 * steps, end));
    expect(gain).toBeGreaterThan(order - 0.5);
    expect(gain).toBeLessThan(order + (order > 4 ? 2.5 : 0.6));
  });
});
