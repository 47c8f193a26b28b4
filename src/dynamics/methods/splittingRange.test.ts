import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { random } from '../../math/random.ts';
import { springForce } from '../forces/springs.ts';
import { uniformField } from '../forces/uniformField.ts';
import { copyState, makeSystem, momenta, type State, type System } from '../system.ts';
import { METHODS } from './library.ts';
import { SplittingRange } from './splittingRange.ts';

const POINTS = 30;

/** Springs between random points, in no order, some to themselves doubled; weight, charges in a magnetic field. */
function net(seed: number, magnetic: boolean): { readonly system: System; readonly start: State } {
  const next = random(seed);
  const point = (): number => Math.floor(next() * POINTS);
  const pairs = Array.from({ length: 120 }, () => [point(), point()]).filter(([a, b]) => a !== b);
  const masses = Float64Array.from({ length: POINTS }, () => 0.5 + next());
  const springs = springForce({
    ends: Uint32Array.from(pairs.flat()),
    stiffness: Float64Array.from(pairs, () => 50 * next()),
    lengths: Float64Array.from(pairs, () => next()),
  });
  const system = makeSystem({
    ...{ masses, c: 3, pinned: Uint8Array.from({ length: POINTS }, () => (next() < 0.1 ? 1 : 0)) },
    forces: [springs, uniformField(masses, [0.1, -9.8, 0.2])],
    ...(magnetic && { charges: masses.map((mass) => mass - 1), magneticField: [0.3, 1, -2] as const }),
  });
  const x = Float64Array.from({ length: 3 * POINTS }, () => 2 * next() - 1);
  const v = Array.from({ length: 3 * POINTS }, () => next() - 0.5);
  return { system, start: { t: 0, x, p: momenta(system, v) } };
}

/** Largest difference of positions. */
const apart = (a: State, b: State): number =>
  a.x.reduce((most, value, j) => Math.max(most, Math.abs(value - b.x[j])), 0);

describe('the stages of a splitting', () => {
  it('give the same bits in parts of any lengths', () => {
    const cuts = fc.uniqueArray(fc.integer({ min: 1, max: POINTS - 1 }), { maxLength: 4 });
    fc.assert(
      fc.property(fc.integer(), fc.boolean(), cuts, (seed, magnetic, at) => {
        const { system, start } = net(seed, magnetic);
        const borders = [0, ...at.sort((a, b) => a - b), POINTS];
        const parts = borders.slice(1).map((end, k) => new SplittingRange(system, borders[k], end));
        const [whole, apiece] = [copyState(start), copyState(start)];
        const range = new SplittingRange(system);
        for (let step = 0; step < 5; step++) {
          range.drift(whole, 0.01);
          range.kick(whole, 0.02, 0.01);
          for (const part of parts) part.drift(apiece, 0.01);
          for (const part of parts) part.sumForces(apiece);
          for (const part of parts) part.applyForces(apiece, 0.02, 0.01);
        }
        expect(apiece).toEqual(whole);
      }),
    );
  });

  it('act on the state that they are given, though they are bound to arrays', () => {
    const { system, start } = net(1, false);
    const [range, a, b] = [new SplittingRange(system), copyState(start), copyState(start)];
    for (const state of [a, b]) range.kick(state, 0.02, 0.01);
    for (const state of [a, b]) range.kick(state, 0.02, 0.01);
    expect(b).toEqual(a);
  });

  it('leave a pinned point where no force is finite', () => {
    const springs = {
      ends: Uint32Array.of(0, 1),
      stiffness: Float64Array.of(Number.MAX_VALUE),
      lengths: Float64Array.of(0),
    };
    const system = makeSystem({
      ...{ masses: Float64Array.of(1, 1), pinned: Uint8Array.of(1, 0), forces: [springForce(springs)] },
    });
    const state = { t: 0, x: Float64Array.of(0, 0, 0, 1e9, 0, 0), p: new Float64Array(6) };
    new SplittingRange(system).kick(state, 1, 1);
    expect([...state.x.subarray(0, 3), ...state.p.subarray(0, 3)]).toEqual([0, 0, 0, 0, 0, 0]);
  });
});

describe.each(['leapfrog', 'yoshida-4', 'yoshida-8'])('steps of %s', (id) => {
  it('taken at once are those taken one by one, but for rounding', () => {
    fc.assert(
      fc.property(fc.integer(), fc.boolean(), (seed, magnetic) => {
        const { system, start } = net(seed, magnetic);
        const [once, each] = [copyState(start), copyState(start)];
        const stepper = METHODS.get(id)!.begin(system);
        stepper.steps!(once, 0.01, 12);
        for (let step = 0; step < 12; step++) stepper.step(each, 0.01);
        expect(apart(once, each)).toBeLessThan(1e-12);
        expect(once.t).toBeCloseTo(each.t, 14);
      }),
      { numRuns: 30 },
    );
  });
});
