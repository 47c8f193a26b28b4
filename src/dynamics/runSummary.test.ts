import { describe, expect, it } from 'vitest';
import { inEnglish } from '../messages/message.ts';
import type { RunRecord } from './runRecord.ts';
import { energyFaultMessage, summarizeRun } from './runSummary.ts';

const TIMES = [0.5, 0.75, 1, 1.25, 1.5];
const NONE = new Float64Array(5);

/** A run with these energies. */
const ran = (total: number[], kinetic: number[], more: Partial<RunRecord> = {}): RunRecord => ({
  method: 'leapfrog',
  speedOfLight: 10,
  step: 0.01,
  pace: 0.25,
  times: Float64Array.from(TIMES),
  steps: Float64Array.of(0, 25, 50, 75, 100),
  kinetic: Float64Array.from(kinetic),
  potential: Float64Array.from(total, (energy, k) => energy - kinetic[k]),
  total: Float64Array.from(total),
  dragLoss: NONE,
  momentum: new Float64Array(15),
  angularMomentum: new Float64Array(15),
  fastest: Float64Array.of(0, 1, 2, 3, 3),
  ...more,
});

describe('the summary of a run', () => {
  it('has the largest change of the energy, and what of it drag did not take', () => {
    const dragLoss = Float64Array.of(0, 1, 2, 2, 3);
    const summary = summarizeRun(ran([10, 9, 8.1, 8, 7], [0, 4, 4, 4, 4], { dragLoss }));
    expect(summary).toEqual({
      ...{ change: 0.75, drift: expect.closeTo(0.025, 12), dragLoss: 3, fastest: 3, until: 1.5 },
    });
  });

  it('tells no drift where it cannot be told, and none where nothing moved', () => {
    const energies = [10, 9, 8, 7, 6];
    const moving = summarizeRun(ran(energies, [0, 4, 4, 4, 4], { hasKinematic: true }));
    expect(moving).toMatchObject({ change: 1, drift: undefined });
    expect(moving).not.toHaveProperty('fault');
    const { dragLoss: _, ...onGpu } = ran(energies, [0, 4, 4, 4, 4]);
    expect(summarizeRun(onGpu)).toMatchObject({ change: 1, drift: undefined, dragLoss: undefined });
    expect(summarizeRun(onGpu)).not.toHaveProperty('fault');
    // Rounding errors only.
    const still = { fastest: Float64Array.of(0, 1e-13, 1e-13, 1e-13, 0) };
    const rounding = summarizeRun(ran([1e-25, 2e-25, 9e-25, 1e-25, 1e-25], [0, 1e-27, 1e-27, 1e-27, 0], still));
    expect(rounding).toMatchObject({ change: undefined, drift: undefined, fastest: 1e-13 });
    expect(summarizeRun(ran([1e9, 1e9 + 1e-5, 1e9, 1e9, 1e9], [0, 1e-8, 1e-8, 1e-8, 0]))).not.toHaveProperty('fault');
  });

  it('names the frame at which the energy is above its minimum so far by more than half of the kinetic energy', () => {
    // Falls by 4, rises by 1.9 of 4, then by 2.1.
    const { fault, drift } = summarizeRun(ran([10, 6, 7.9, 8.1, 20], [0, 4, 4, 4, 9]));
    expect(fault).toEqual({ kind: 'gained', t: 1.25, share: expect.closeTo(14 / 9, 12) });
    expect(drift).toBeCloseTo(10 / 9, 12);
  });

  it('names the frame from which on more than a twentieth of the kinetic energy is lost, or gained', () => {
    const of = (...total: number[]) => summarizeRun(ran(total, [0, 4, 8, 8, 8])).fault;
    // An oscillation: at the end it is back.
    expect(of(10, 9, 9.9, 9, 9.8)).toBeUndefined();
    expect(of(10, 9, 9.9, 9.2, 9)).toEqual({ kind: 'lost', t: 1.25, share: expect.closeTo(0.125, 12) });
    expect(of(10, 10.1, 10.5, 11, 10.5)).toEqual({ kind: 'gained', t: 1, share: expect.closeTo(0.125, 12) });
    // Drag took it.
    const dragLoss = Float64Array.of(0, 1, 1.5, 2, 3);
    expect(summarizeRun(ran([10, 9, 8.5, 8, 7], [0, 4, 8, 8, 8], { dragLoss })).fault).toBeUndefined();
    expect(inEnglish(energyFaultMessage(of(10, 9, 9.9, 9.2, 9)!))).toMatch(
      /^from t = 1\.250 s on energy is missing .* 13 % .*: an error of the method; set a shorter step/,
    );
  });
});
