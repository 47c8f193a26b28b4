import { describe, expect, it } from 'vitest';
import { springForce } from './forces/springs.ts';
import { METHODS } from './methods/library.ts';
import { integrate, type RunOptions } from './run.ts';
import { type RunRecord, RunRecorder, runRecordCsv } from './runRecord.ts';
import { makeSystem, momenta } from './system.ts';

/** Two masses on a spring, one thrown at 0.6 c: γ = 1.25. */
function thrown(): RunOptions {
  const system = makeSystem({
    masses: Float64Array.of(2, 3),
    c: 5,
    forces: [springForce({ ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(8), lengths: Float64Array.of(1) })],
  });
  const start = {
    t: 0.5,
    x: Float64Array.of(0, 0, 0, 2, 0, 0),
    p: momenta(system, [0, 3, 0, 0, 0, 0]),
  };
  return { system, start, method: METHODS.get('discrete-gradient')!, duration: 1, every: 0.25, step: 0.01 };
}

function kept(order: RunOptions): RunRecord {
  const keeper = new RunRecorder(order);
  const running = integrate(order);
  for (let next = running.next(); ; next = running.next()) {
    if (next.done) return keeper.record(next.value);
    keeper.addFrame(next.value);
  }
}

describe('the record of a run', () => {
  it('has the conserved quantities of each frame', () => {
    const record = kept(thrown());
    expect([record.method, record.speedOfLight, record.step, record.pace]).toEqual([
      'discrete-gradient',
      5,
      0.01,
      0.25,
    ]);
    expect([...record.times]).toEqual([0.5, 0.75, 1, 1.25, 1.5]);
    expect([...record.steps]).toEqual([0, 25, 50, 75, 100]);
    // (γ − 1) m c² = 0.25 · 2 · 25; ½k(r − L)² = 4; p = γmv = 7.5 along y at the origin.
    expect([record.kinetic[0], record.potential[0], record.fastest[0]]).toEqual([12.5, 4, expect.closeTo(3, 12)]);
    expect([...record.momentum.subarray(0, 3)]).toEqual([0, 7.5, 0]);
    for (let i = 0; i < 5; i++) {
      expect(record.total[i]).toBeCloseTo(16.5, 11);
      expect(record.momentum[3 * i + 1]).toBeCloseTo(7.5, 11);
      expect(record.angularMomentum[3 * i + 2]).toBeCloseTo(0, 11);
    }
    expect(record.stop).toBeUndefined();
  });

  it('ends with the run, and records why', () => {
    const { stop, times } = kept({
      ...thrown(),
      method: METHODS.get('semi-implicit-euler-0')!,
      step: 2,
      every: 2,
      duration: 200,
    });
    expect(stop?.reason).toBe('light');
    expect(times.length).toBeLessThan(100);
  });

  it('is a table with units that reads back to the same numbers', () => {
    const record = kept(thrown());
    const [head, ...rows] = runRecordCsv(record).trimEnd().split('\n');
    expect(head.split(',').slice(0, 3)).toEqual(['time [s]', 'steps', 'kinetic energy [J]']);
    const numbers = rows.map((row) => row.split(',').map(Number));
    expect(numbers.every((row) => row.length === head.split(',').length)).toBe(true);
    expect(numbers.map((row) => row[4])).toEqual([...record.total]);
    expect(numbers.map((row) => row.at(-2))).toEqual([...record.fastest]);
    expect(numbers.map((row) => row.at(-1))).toEqual([0, 0, 0, 0, 0]);
    expect(numbers.map((row) => row[6])).toEqual(Array.from({ length: 5 }, (_, i) => record.momentum[3 * i + 1]));
  });
});
