import { describe, expect, it } from 'vitest';
import { add, build } from '../../../tests/support/graphKit.ts';
import { lineStyle } from '../../diagrams/lineStyle.ts';
import type { RunRecord } from '../../dynamics/runRecord.ts';
import type { NodeResult } from '../../graph/evaluation/resultCache.ts';
import { inEnglish } from '../../messages/message.ts';
import { computedUntil, simulationRuns, unevaluatedSimulations } from '../state/simulationRuns.ts';
import { runNames } from './runNames.ts';
import { frameIndexAt, onLinearAxis, onLogarithmicAxis, unitOf, valuesOf } from './series.ts';
import { tick } from './ticks.ts';

/** Three frames; the maximum kinetic energy is 3 J, and 1.5 J are lost. */
const record: RunRecord = {
  method: 'leapfrog',
  speedOfLight: 10,
  step: 0.01,
  pace: 0.5,
  times: Float64Array.of(0, 0.5, 1),
  steps: Float64Array.of(0, 50, 100),
  kinetic: Float64Array.of(0, 3, 1),
  potential: Float64Array.of(4, 0, 1.5),
  total: Float64Array.of(4, 3, 2.5),
  momentum: Float64Array.of(0, 0, 0, 3, 0, -4, 0, 5, 12),
  angularMomentum: Float64Array.of(0, 0, 0, 1, 2, 2, 0, 0, 0),
  fastest: Float64Array.of(0, 8, 5),
};
const done = (outputs: Record<string, unknown>, interim?: true): NodeResult => ({
  status: 'done',
  outputs,
  ...(interim && { interim }),
});

describe('the run records of an evaluation', () => {
  it('are listed once, by the node that produced them, also if passed on', () => {
    const results = new Map<string, NodeResult>([
      ['box', done({ geometry: {} })],
      ['run', done({ geometry: {}, books: record }, true)],
      ['passed', done({ books: record }, true)],
      ['gone', { status: 'blocked', by: 'box' }],
      ['outer/run', done({ books: { ...record, times: Float64Array.of(0, 3) } })],
    ]);
    expect(simulationRuns(results).map(({ node, interim }) => [node, interim])).toEqual([
      ['run', true],
      ['outer/run', false],
    ]);
    // Only runs that are still being computed count.
    expect(computedUntil(results)).toBe(1);
    expect(computedUntil(new Map())).toBe(Number.POSITIVE_INFINITY);
  });

  it('do not include nodes that the evaluation does not need', () => {
    const document = build(add('run', 'simulate'), add('other', 'simulate'), add('box', 'box'));
    expect(unevaluatedSimulations(document, new Map([['run', done({ books: record })]]))).toEqual(['other']);
    expect(unevaluatedSimulations(document, new Map(['run', 'other'].map((node) => [node, done({})])))).toEqual([]);
  });

  it('yield the plotted series', () => {
    expect([...valuesOf(record, 'change', 'J')]).toEqual([0, -1, -1.5]);
    expect([...valuesOf(record, 'potential', 'J')]).toEqual([4, 0, 1.5]);
    expect([...valuesOf(record, 'momentum', 'kg m/s')]).toEqual([0, 5, 13]);
    expect([...valuesOf(record, 'angularMomentum', 'kg m²/s')]).toEqual([0, 3, 0]);
    expect([...valuesOf(record, 'fastest', 'c')]).toEqual([0, 0.8, 0.5]);
  });

  it('have speeds in m/s if one of them has no speed of light', () => {
    const run = (speedOfLight: number) => ({ node: 'run', interim: false, record: { ...record, speedOfLight } });
    expect(unitOf('fastest', [run(10), run(1)])).toBe('c');
    expect(unitOf('fastest', [run(10), run(Number.POSITIVE_INFINITY)])).toBe('m/s');
    expect([...valuesOf(record, 'fastest', 'm/s')]).toEqual([0, 8, 5]);
  });

  it('have what drag took apart from the drift, which moving objects and drag on a GPU hide', () => {
    const damped = { ...record, dragLoss: Float64Array.of(0, 1, 1.25) };
    expect([...valuesOf(damped, 'drift', 'J')]).toEqual([0, 0, -0.25]);
    expect([...valuesOf(damped, 'dragLoss', 'J')]).toEqual([0, 1, 1.25]);
    expect([...valuesOf({ ...damped, hasKinematic: true }, 'drift', 'J')]).toEqual([
      Number.NaN,
      Number.NaN,
      Number.NaN,
    ]);
    expect(onLinearAxis(valuesOf(record, 'drift', 'J'))).toEqual([null, null, null]);
  });
});

it('runs are named by title or method, or by what distinguishes them if these are equal', () => {
  const run = (node: string, method: string, speedOfLight = 10) => ({
    node,
    interim: false,
    record: { ...record, method, speedOfLight },
  });
  const names = (...runs: Parameters<typeof runNames>[0]) =>
    runNames(runs, (node) => (node === 'mine' ? 'My cloth' : undefined), inEnglish);
  expect(
    names(run('mine', 'leapfrog'), run('a', 'leapfrog'), run('b', 'local-global-2'), run('e', 'yoshida-4')),
  ).toEqual(['My cloth', 'Leapfrog', 'Local–global 2', 'Yoshida 4']);
  expect(names(run('a', 'leapfrog', 1), run('b', 'leapfrog', 100), run('c', 'yoshida-4'))).toEqual([
    'Leapfrog, c = 1 m/s',
    'Leapfrog, c = 100 m/s',
    'Yoshida 4',
  ]);
  expect(names(run('a', 'leapfrog'), run('b', 'leapfrog'))).toEqual(['Leapfrog (a)', 'Leapfrog (b)']);
});

it('values at a time are those of the previous frame', () => {
  expect([-1, 0, 0.49, 0.5, 7].map((t) => frameIndexAt(record.times, t))).toEqual([-1, 0, 0, 1, 2]);
});

it('a logarithmic axis shows absolute values, and gaps for zeros', () => {
  expect(onLogarithmicAxis(Float64Array.of(-1e-12, 0, 2, Number.NaN))).toEqual([1e-12, null, 2, null]);
});

it('axis labels are short', () => {
  const numbers = [0.1 + 0.2, -2500, 1e-10, 3e6, 0, null];
  expect(numbers.map(tick)).toEqual(['0.3', '−2500', '1e−10', '3e6', '0', '']);
});

it('each of six lines has its own colour and dash pattern', () => {
  for (const scheme of ['light', 'dark'] as const) {
    const styles = Array.from({ length: 6 }, (_, i) => lineStyle(i, scheme));
    expect(new Set(styles.map(({ color }) => color)).size).toBe(6);
    expect(new Set(styles.map(({ dash }) => dash.join())).size).toBe(6);
  }
});
