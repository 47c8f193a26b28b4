import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { springForce } from '../dynamics/forces/springs.ts';
import { Integrator } from '../dynamics/integrator.ts';
import { METHODS } from '../dynamics/methods/library.ts';
import { makeSystem, momenta } from '../dynamics/system.ts';
import { type SplittingStage, splittingStagesOf } from './splittingStages.ts';

const SPLITTINGS = ['leapfrog', 'yoshida-4', 'yoshida-6', 'yoshida-8'];
const rowOf = (fractions: readonly number[], h: number, drag: number, steps: number): SplittingStage[] => {
  const { begin, within, between, end } = splittingStagesOf(fractions, h, drag);
  const each = Array.from({ length: steps }, () => [...within, between]).flat();
  return [begin, ...each.slice(0, -1), end];
};

/** Effect of passes on a mass on a spring in one dimension, in 64 bits. */
function passed(row: readonly SplittingStage[], from: readonly [x: number, p: number], k: number, c: number): number[] {
  let [x, p] = from;
  const v = (): number => p / Math.hypot(1, p / c);
  for (const { kick, drift, damp, after } of row) {
    p += kick * -k * x;
    x += drift * v();
    p -= damp * p;
    x += after * v();
  }
  return [x, p];
}

describe.each(SPLITTINGS)('the passes of %s', (id) => {
  const { coefficients: fractions } = METHODS.get(id)!;

  it('equal its steps, with drag before and after each', () => {
    const [k, c] = [3, 2];
    const spring = { ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(k), lengths: Float64Array.of(0) };
    fc.assert(
      fc.property(
        fc.double({ min: -1, max: 1, noNaN: true }),
        fc.double({ min: -1.9, max: 1.9, noNaN: true }),
        fc.integer({ min: 1, max: 5 }),
        fc.constantFrom(0, 0.7),
        (x, v, steps, drag) => {
          const pinned = Uint8Array.of(0, 1);
          const system = makeSystem({ masses: Float64Array.of(1, 1), pinned, c, drag, forces: [springForce(spring)] });
          const state = { t: 0, x: Float64Array.of(x, 0, 0, 0, 0, 0), p: momenta(system, [v, 0, 0, 0, 0, 0]) };
          const begun = [x, state.p[0]] as const;
          const mover = new Integrator(system, METHODS.get(id)!);
          for (let i = 0; i < steps; i++) mover.step(state, 0.1);
          const [at, p] = passed(rowOf(fractions!, 0.1, drag, steps), begun, k, c);
          expect(at).toBeCloseTo(state.x[0], 12);
          expect(p).toBeCloseTo(state.p[0], 12);
        },
      ),
    );
  });

  it('have the time drifted since the previous pass', () => {
    const row = rowOf(fractions!, 0.1, 0, 3);
    row.slice(1).forEach(({ before }, i) => {
      const { drift, after } = row[i];
      // The first pass of a batch counts the last drift of the batch before.
      expect(before).toBeCloseTo(i === 0 ? 2 * after : drift + after, 15);
    });
  });
});
