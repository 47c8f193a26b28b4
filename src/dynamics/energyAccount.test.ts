import { describe, expect, it } from 'vitest';
import { saying } from '../../tests/support/inWords.ts';
import { springForce } from './forces/springs.ts';
import { uniformField } from './forces/uniformField.ts';
import { meshSprings } from './meshSprings.ts';
import { METHODS } from './methods/library.ts';
import { type EarlyStop, integrate, type RunOptions, type SimulationFrame } from './run.ts';
import { RunRecorder } from './runRecord.ts';
import { summarizeRun } from './runSummary.ts';
import { makeSystem, momenta, type System, stateAtRest } from './system.ts';

/** All frames of a run, its record and why it ended. */
function ran(options: Omit<RunOptions, 'method'>, id: string) {
  const order = { ...options, method: METHODS.get(id)! };
  const recorder = new RunRecorder(order);
  const frames: SimulationFrame[] = [];
  const running = integrate(order);
  for (;;) {
    const { done, value } = running.next();
    if (done) return { frames, record: recorder.record(value as EarlyStop | undefined), stop: value as EarlyStop };
    frames.push(value);
    recorder.addFrame(value);
  }
}

/** A point of 1 kg on a spring of zero length to a pinned point at the origin. */
const oscillator = (c: number, k: number): System =>
  makeSystem({
    masses: Float64Array.of(1, 1),
    pinned: Uint8Array.of(1, 0),
    c,
    forces: [springForce({ ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(k), lengths: Float64Array.of(0) })],
  });
const fromAmplitude = (A: number) => stateAtRest(Float64Array.of(0, 0, 0, A, 0, 0));

/** Quarter of its period by the midpoint rule over θ, x = A sin θ: ∫ dx/v, v = c √(γ² − 1)/γ, γ = 1 + k(A² − x²)/2c². */
function quarterPeriod(c: number, k: number, A: number): number {
  const n = 2000;
  let sum = 0;
  for (let i = 0; i < n; i++) {
    const theta = ((i + 0.5) * Math.PI) / (2 * n);
    const gain = (k * (A * Math.cos(theta)) ** 2) / (2 * c * c);
    sum += (A * Math.cos(theta) * (1 + gain)) / (c * Math.sqrt(gain * (gain + 2)));
  }
  return (sum * Math.PI) / (2 * n);
}

/** A 6 × 6 cloth of the source documents, released level, held at two corners. */
function cloth(c: number): Omit<RunOptions, 'method'> {
  const n = 6;
  const x = Float64Array.from({ length: 3 * n * n }, (_, j) => {
    const i = Math.floor(j / 3);
    return [(i % n) / (n - 1), 0, Math.floor(i / n) / (n - 1)][j % 3];
  });
  const faces = Array.from({ length: (n - 1) ** 2 }, (_, f) => {
    const a = Math.floor(f / (n - 1)) * n + (f % (n - 1));
    return [a, a + 1, a + n + 1, a + n];
  });
  const topology = { counts: new Uint32Array(faces.length).fill(4), corners: Uint32Array.from(faces.flat()) };
  const springs = meshSprings(x, topology, { structural: 1000, shear: 1000, bending: 1000 });
  const masses = new Float64Array(n * n).fill(1 / (n * n));
  const pinned = new Uint8Array(n * n);
  pinned[0] = 1;
  pinned[n - 1] = 1;
  const forces = [springForce(springs), uniformField(masses, [0, -9.8, 0])];
  const system = makeSystem({ masses, pinned, forces, c });
  return { system, start: stateAtRest(x), duration: 1, every: 0.02, step: 0.001 };
}

const ROOT = ['semi-implicit-euler-3', 'linearly-implicit-3', 'local-global-3'];

describe('the correction by the root', () => {
  const [C, K, A] = [1, 4, 1.5];
  const period = 4 * quarterPeriod(C, K, A);

  it.each(ROOT)(
    '%s keeps a relativistic oscillator’s energy to rounding, also where it turns, and its period',
    (id) => {
      const system = oscillator(C, K);
      const options = { system, start: fromAmplitude(A), duration: 3 * period, every: period / 8, step: period / 4000 };
      const { record, stop, frames } = ran(options, id);
      expect(stop).toBeUndefined();
      expect(summarizeRun(record).drift).toBeLessThan(1e-12);
      // ½kA² = 4.5 mc²: γ = 5.5 at the origin. First-order steps err by some thousandths of the amplitude.
      expect(summarizeRun(record).fastest).toBeCloseTo(Math.sqrt(1 - 5.5 ** -2), 2);
      for (const turns of [1, 2, 3]) expect(frames[8 * turns].state.x[3]).toBeCloseTo(A, 1);
      for (const turns of [0.5, 1.5]) expect(frames[8 * turns].state.x[3]).toBeCloseTo(-A, 1);
    },
  );

  it.each(ROOT)('%s keeps that of a cloth, at 1, 10 and 100 m/s', (id) => {
    for (const c of [1, 10, 100]) {
      // At 1 m/s a step gives a point the speed of light soon.
      const { record, stop } = ran({ ...cloth(c), ...(c === 1 && { duration: 0.4 }) }, id);
      expect(stop).toBeUndefined();
      const { drift, fastest, fault } = summarizeRun(record);
      expect(drift).toBeLessThan(1e-12);
      expect(fastest / c).toBeGreaterThan(c === 1 ? 0.9 : 0.02);
      expect(fault).toBeUndefined();
      expect(record.corrected).toBe(record.steps.at(-1));
    }
  });

  it('ends the run where the potential energy alone is more than all', () => {
    // Newton’s oscillator from the origin, ω = 2/s, a step of 1.5 s: it would be at three amplitudes.
    const system = oscillator(Number.POSITIVE_INFINITY, 4);
    const start = { t: 0, x: new Float64Array(6), p: momenta(system, [0, 0, 0, 1, 0, 0]) };
    const { frames, stop } = ran({ system, start, duration: 15, every: 1.5, step: 1.5 }, 'semi-implicit-euler-3');
    expect(frames).toHaveLength(1);
    // V = ½ · 4 · 1.5² = 4.5 J, and there is 0.5 J.
    expect(stop).toMatchObject({ reason: 'energy', t: 0, message: saying(/potential energy alone is 4\.00 J above/) });
  });
});

it('the secant leaves linearly implicit steps as they are, which only lose energy, and the loss is a fault', () => {
  const [plain, secant] = ['linearly-implicit-0', 'linearly-implicit-2'].map(
    (id) => ran({ ...cloth(10), duration: 3 }, id).record,
  );
  expect(secant.corrected).toBe(0);
  expect(plain).not.toHaveProperty('corrected');
  expect(secant.total).toEqual(plain.total);
  expect(summarizeRun(plain).fault).toMatchObject({ kind: 'lost' });
});

describe('the energy that drag takes', () => {
  const [C, DRAG] = [2, 0.8];

  it.each(['leapfrog', 'yoshida-6', 'discrete-gradient', 'semi-implicit-euler-0'])(
    'by %s is that of p = p₀ exp(−drag t), and no drift',
    (id) => {
      const system = makeSystem({ masses: Float64Array.of(3), c: C, drag: DRAG });
      const start = { t: 0, x: new Float64Array(3), p: Float64Array.of(0, 12, 0) };
      const { record } = ran({ system, start, duration: 2, every: 0.5, step: 0.01 }, id);
      const kinetic = (t: number): number => Math.hypot(3 * C * C, 12 * Math.exp(-DRAG * t) * C) - 3 * C * C;
      record.times.forEach((t, k) => {
        expect(record.dragLoss![k]).toBeCloseTo(kinetic(0) - kinetic(t), 11);
      });
      expect(summarizeRun(record)).toMatchObject({ drift: expect.closeTo(0, 12), dragLoss: record.dragLoss!.at(-1) });
      expect(summarizeRun(record).change).toBeGreaterThan(0.7);
    },
  );

  it('of a fall is ∫ k m v² dt with v = (g/k)(1 − exp(−kt))', () => {
    const [g, k, m, T] = [9.8, 1.3, 2, 1.5];
    const masses = Float64Array.of(m);
    const system = makeSystem({ masses, drag: k, forces: [uniformField(masses, [0, -g, 0])] });
    const start = stateAtRest(Float64Array.of(0, 10, 0));
    const { record } = ran({ system, start, duration: T, every: T, step: 1e-4 }, 'leapfrog');
    const [e, e2] = [Math.exp(-k * T), Math.exp(-2 * k * T)];
    const closed = ((m * g * g) / k) * (T - (2 * (1 - e)) / k + (1 - e2) / (2 * k));
    expect(record.dragLoss![1]).toBeCloseTo(closed, 5);
    expect(summarizeRun(record).drift).toBeLessThan(1e-6);
  });

  it('and the rest of it are constant to rounding by the discrete gradient; adaptive steps count what they keep', () => {
    const system = { ...oscillator(C, 9), drag: DRAG };
    const options = { system, start: fromAmplitude(1), duration: 4, every: 0.25, step: 0.01 };
    expect(summarizeRun(ran(options, 'discrete-gradient').record).drift).toBeLessThan(1e-13);
    const { record } = ran({ ...options, tolerance: 1e-5 }, 'discrete-gradient');
    expect(summarizeRun(record).drift).toBeLessThan(1e-13);
    expect(summarizeRun(record).change).toBeGreaterThan(0.9);
  });

  it('continues to the bit in a resumed run', () => {
    const system = { ...oscillator(C, 9), drag: DRAG };
    const options = { system, start: fromAmplitude(1), duration: 2, every: 0.25, step: 0.01 };
    const whole = ran(options, 'semi-implicit-euler-1').frames;
    const { state: start, quantities: _, ...tally } = whole[3];
    const since = { t: 0, frames: 3, tally };
    const rest = ran({ ...options, start, since, duration: 1.25 }, 'semi-implicit-euler-1').frames;
    expect(rest.map(({ dragLoss, steps, corrected }) => [dragLoss, steps, corrected])).toEqual(
      whole.slice(3).map(({ dragLoss, steps, corrected }) => [dragLoss, steps, corrected]),
    );
    expect(tally.corrected).toBeGreaterThan(0);
  });
});
