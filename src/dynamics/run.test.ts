import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { recordRun, sheet } from '../../tests/support/clothKit.ts';
import { english } from '../../tests/support/inWords.ts';
import { uniform as between } from '../../tests/support/physicsArbitraries.ts';
import { random } from '../math/random.ts';
import { AdaptiveSteps } from './adaptiveSteps.ts';
import { barrier } from './forces/barrier.ts';
import { PenaltyPotential, sphereContacts } from './forces/contact.ts';
import { coulomb } from './forces/coulomb.ts';
import { NeighborPairs } from './forces/neighborPairs.ts';
import { box } from './forces/obstacle.ts';
import { PairForce } from './forces/pairs.ts';
import { springForce } from './forces/springs.ts';
import { uniformField } from './forces/uniformField.ts';
import { Integrator } from './integrator.ts';
import { meshSprings } from './meshSprings.ts';
import { METHODS } from './methods/library.ts';
import { integrate, type RunOptions, type SimulationFrame, stepSchedule } from './run.ts';
import { maxAngularFrequency } from './stability.ts';
import { copyState, makeSystem, momenta, type System, SystemError, stateAtRest, velocities } from './system.ts';

function hanging(n: number, c: number, drag = 0): Pick<RunOptions, 'system' | 'start'> {
  const { x, faces } = sheet(n);
  const masses = new Float64Array(n * n).fill(1 / (n * n));
  const pinned = new Uint8Array(n * n);
  pinned[0] = pinned[n - 1] = 1;
  const net = springForce(meshSprings(x, faces, { structural: 1000, shear: 1000, bending: 1000 }));
  return {
    system: makeSystem({ masses, pinned, c, drag, forces: [net, uniformField(masses, [0, -9.8, 0])] }),
    start: stateAtRest(x),
  };
}

const method = (id: string) => METHODS.get(id)!;

describe('springs of a mesh', () => {
  it('are along edges, across faces, and to the second neighbour: each once, with the initial length as rest length', () => {
    const n = 5;
    const { x, faces } = sheet(n);
    const of = (structural: number, shear: number, bending: number) =>
      meshSprings(x, faces, { structural, shear, bending }).lengths;
    const side = 1 / (n - 1);
    expect(of(1, 0, 0)).toHaveLength(2 * n * (n - 1));
    expect(of(0, 1, 0)).toHaveLength(2 * (n - 1) ** 2);
    expect(of(0, 0, 1)).toHaveLength(2 * n * (n - 2));
    expect(of(1, 0, 0).every((length) => Math.abs(length - side) < 1e-12)).toBe(true);
    expect(of(0, 1, 0).every((length) => Math.abs(length - Math.SQRT2 * side) < 1e-12)).toBe(true);
    expect(of(0, 0, 1).every((length) => Math.abs(length - 2 * side) < 1e-12)).toBe(true);
  });

  it('resist bending over edges between triangles, and reject faces with missing points', () => {
    const x = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
    const two = { counts: [3, 3], corners: [0, 1, 2, 1, 3, 2] };
    const { ends } = meshSprings(x, two, { structural: 0, shear: 1, bending: 1 });
    expect([...ends]).toEqual([0, 3]);
    expect(() => meshSprings(x, { counts: [3], corners: [0, 1, 7] }, { structural: 1, shear: 0, bending: 0 })).toThrow(
      SystemError,
    );
  });
});

describe('near pairs', () => {
  it('are all pairs within reach, wherever the points have moved since the last search', () => {
    const n = 60;
    const next = random(5);
    const bodies = Int32Array.from({ length: n }, (_, i) => (i % 4) - 1);
    const law = new PenaltyPotential(10, () => 0.3);
    const rest = Float64Array.from({ length: 3 * n }, next);
    const far = (i: number, j: number): boolean =>
      Math.hypot(...[0, 1, 2].map((k) => rest[3 * i + k] - rest[3 * j + k])) > 0.3;
    const near = new NeighborPairs(bodies, rest, 0.3, law);
    const all = new PairForce(
      Uint32Array.from(
        Array.from({ length: n * n }, (_, k) => [Math.floor(k / n), k % n])
          .filter(([i, j]) => i < j && bodies[i] >= 0 && bodies[j] >= 0 && (bodies[i] !== bodies[j] || far(i, j)))
          .flat(),
      ),
      law,
    );
    let x = Float64Array.from({ length: 3 * n }, next);
    for (let step = 0; step < 60; step++) {
      const to = x.map((value) => value + (step % 7 === 0 ? 0.6 : 0.06) * (next() - 0.5));
      const sums = [near, all].map((force) => {
        const sum = new Float64Array(3 * n);
        force.add(x, sum);
        force.addDiscreteGradient(x, to, sum);
        return sum;
      });
      expect(near.energy(to)).toBeCloseTo(all.energy(to), 12);
      sums[0].forEach((value, j) => {
        expect(value).toBeCloseTo(sums[1][j], 11);
      });
      x = to;
    }
  });
});

describe('contact', () => {
  /** Points of four bodies in soft contact. */
  const crowd = (seed: number): Pick<RunOptions, 'system' | 'start'> => {
    const n = 80;
    const next = random(seed);
    const bodies = Int32Array.from({ length: n }, (_, i) => i % 4);
    const x = Float64Array.from({ length: 3 * n }, next);
    const near = new NeighborPairs(bodies, x, 0.3, new PenaltyPotential(0.05, () => 0.3));
    const system = makeSystem({ masses: new Float64Array(n).fill(0.1), c: 3, forces: [near] });
    const p = momenta(
      system,
      Array.from(x, () => next() - 0.5),
    );
    return { system, start: { t: 0, x, p } };
  };

  it.each(['leapfrog', 'discrete-gradient'])(
    'gives the same bits in a resumed run, although near pairs are searched from another state: %s',
    (id) => {
      const order = { method: method(id), step: 2e-3, every: 0.07 };
      for (let seed = 1; seed <= 4; seed++) {
        const { frames } = recordRun({ ...crowd(seed), ...order, duration: 0.56 });
        for (const from of [1, 3, 5]) {
          const again = recordRun({
            ...crowd(seed),
            ...order,
            start: frames[from].state,
            duration: 0.56 - 0.07 * from,
          });
          expect(again.frames.map(({ quantities }) => quantities)).toEqual(
            frames.slice(from).map(({ quantities }) => quantities),
          );
          expect(again.frames.at(-1)!.state.x).toEqual(frames.at(-1)!.state.x);
        }
      }
    },
  );
});

describe('two sheets of one object thrown at each other', () => {
  const side = 5;
  const count = 2 * side * side;
  const leaf = (i: number): number => (i < count / 2 ? -1 : 1);
  const x = Float64Array.from({ length: 3 * count }, (_, j) => {
    const i = Math.floor(j / 3);
    const [row, column] = [Math.floor((i % (side * side)) / side), i % side];
    return [0.2 * leaf(i), 0.1 * row + 0.03 * leaf(i), 0.1 * column][j % 3];
  });
  const corners = [0, 1].flatMap((which) =>
    Array.from({ length: (side - 1) ** 2 }, (_, k) => {
      const a = which * side * side + Math.floor(k / (side - 1)) * side + (k % (side - 1));
      return [a, a + 1, a + side + 1, a + side];
    }).flat(),
  );
  const faces = { counts: new Uint8Array(2 * (side - 1) ** 2).fill(4), corners };
  const net = springForce(meshSprings(x, faces, { structural: 300, shear: 300, bending: 100 }));
  const masses = new Float64Array(count).fill(0.01);
  const touch = new NeighborPairs(new Int32Array(count), x, 0.12, new PenaltyPotential(500, () => 0.12));
  const flight = (forces: System['forces']) => {
    const system = makeSystem({ masses, c: 10, forces });
    const v = x.map((_, j) => (j % 3 === 0 ? -2 * leaf(Math.floor(j / 3)) : 0));
    const start = { t: 0, x, p: momenta(system, v) };
    const method = METHODS.get('discrete-gradient')!;
    return [...integrate({ system, start, method, duration: 0.4, every: 0.02, step: 1e-3 })];
  };
  const isApart = ({ state }: SimulationFrame): boolean => {
    const sides = [-1, 1].map((which) => Array.from(masses.keys()).filter((i) => leaf(i) === which));
    const [left, right] = sides.map((points) => points.map((i) => state.x[3 * i]));
    return Math.max(...left) < Math.min(...right);
  };

  it('separate again with the same energy and momentum', () => {
    const frames = flight([net, touch]);
    const [first, last] = [frames[0].quantities, frames.at(-1)!.quantities];
    expect(frames).toHaveLength(21);
    expect(frames.every(isApart)).toBe(true);
    expect(Math.min(...frames.map(({ quantities }) => quantities.kinetic))).toBeLessThan(0.9 * first.kinetic);
    expect(Math.abs(last.total - first.total)).toBeLessThan(1e-10 * first.kinetic);
    expect(Math.hypot(...last.momentum)).toBeLessThan(1e-12);
    const outward = frames
      .at(-1)!
      .state.p.reduce((sum, p, j) => sum + (j % 3 === 0 ? p * leaf(Math.floor(j / 3)) : 0), 0);
    expect(outward).toBeGreaterThan(0);
    expect(flight([net]).every(isApart)).toBe(false);
  });
});

describe('the fastest oscillation', () => {
  it('is bounded: leapfrog is stable below the bound, and a chain approaches it', () => {
    fc.assert(
      fc.property(between(0.1, 10), between(1, 1000), (m, k) => {
        const n = 30;
        const ends = Uint32Array.from({ length: 2 * (n - 1) }, (_, i) => (i + 1) >> 1);
        const system = makeSystem({
          masses: new Float64Array(n).fill(m),
          forces: [
            springForce({
              ends,
              stiffness: new Float64Array(n - 1).fill(k),
              lengths: new Float64Array(n - 1).fill(0.1),
            }),
          ],
        });
        // For a long chain: 2√(k/m), and for n points that times cos(π/2n).
        const exact = 2 * Math.sqrt(k / m) * Math.cos(Math.PI / (2 * n));
        expect(maxAngularFrequency(system)).toBeGreaterThan(exact);
        expect(maxAngularFrequency(system)).toBeLessThan(1.01 * exact);
      }),
    );
  });
});

describe('the fastest oscillation of unequal masses', () => {
  it('is bounded by the lightest: two masses on a spring oscillate with √(k/μ)', () => {
    fc.assert(
      fc.property(between(0.01, 100), between(0.01, 100), between(1, 1000), (m, n, k) => {
        const one = { ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(k), lengths: Float64Array.of(1) };
        const masses = Float64Array.of(m, n);
        const exact = Math.sqrt(k / m + k / n);
        const bound = maxAngularFrequency(makeSystem({ masses, forces: [springForce(one)] }));
        expect(bound).toBeGreaterThan(exact * (1 - 1e-12));
        expect(bound).toBeLessThan(Math.SQRT2 * exact * (1 + 1e-12));
        // A pinned point does not oscillate: the bound is that of the other alone.
        const held = maxAngularFrequency(
          makeSystem({ masses, pinned: Uint8Array.of(1, 0), forces: [springForce(one)] }),
        );
        expect(held).toBeCloseTo(Math.sqrt((2 * k) / n), 9);
      }),
    );
  });
});

describe('a run', () => {
  it('yields frames at their times, with equal steps in between, and conserves energy', () => {
    const { frames, stop } = recordRun({
      ...hanging(6, 10),
      method: method('discrete-gradient'),
      duration: 0.5,
      every: 0.1,
      step: 0.011,
    });
    expect(stop).toBeUndefined();
    expect(frames.map(({ state }) => state.t)).toEqual([0, 0.1, 0.2, 0.30000000000000004, 0.4, 0.5]);
    expect(frames.map(({ steps }) => steps)).toEqual([0, 10, 20, 30, 40, 50]);
    const total = frames.map(({ quantities }) => quantities.total);
    const kinetic = Math.max(...frames.map(({ quantities }) => quantities.kinetic));
    expect(Math.max(...total) - Math.min(...total)).toBeLessThan(1e-11 * kinetic);
  });

  it.each([
    ['leapfrog', 1],
    ['discrete-gradient', 1],
    ['discrete-gradient', 20],
  ])('is deterministic, also when resumed from a frame: %s, with steps %i times as long', (id, times) => {
    const step = times * stepSchedule({ ...hanging(5, 5), method: method(id), every: 0.05, duration: 1 }).h;
    const order = { ...hanging(5, 5), method: method(id), every: 0.05, step };
    const { frames } = recordRun({ ...order, duration: 0.4 });
    const again = recordRun({ ...order, start: frames[4].state, duration: 0.2 });
    expect(again.frames.at(-1)!.state.x).toEqual(frames.at(-1)!.state.x);
    expect(again.frames.at(-1)!.state.p).toEqual(frames.at(-1)!.state.p);
  });

  it('loses momentum to air drag: p falls as exp(−drag t)', () => {
    const system = makeSystem({ masses: Float64Array.of(2), c: 3, drag: 0.7 });
    const start = { t: 0, x: new Float64Array(3), p: Float64Array.of(5, 0, 0) };
    const { frames } = recordRun({ system, start, method: method('leapfrog'), duration: 2, every: 1 });
    expect(frames[2].state.p[0]).toBeCloseTo(5 * Math.exp(-1.4), 12);
  });

  it('stops with its last valid state if steps exceed the stability bound, and reports the bound', () => {
    const order = { ...hanging(8, 10), method: method('leapfrog'), duration: 5, every: 0.02, step: 0.01 };
    expect(stepSchedule(order).stable).toBe(false);
    const { frames, stop } = recordRun(order);
    expect(stop?.reason).toBe('unstable');
    expect(english(stop?.message)).toContain('steps of 0.0100 s are longer than the method can take here, ');
    const energies = frames.map(({ quantities }) => quantities);
    expect(energies.every(({ total, kinetic }) => total - energies[0].total <= 0.5 * kinetic)).toBe(true);
    expect(frames.length).toBeLessThan(250);
  });

  it('stops where a published method exceeds c, and reports the point', () => {
    const tight = springForce({
      ends: Uint32Array.of(0, 1),
      stiffness: Float64Array.of(100),
      lengths: Float64Array.of(0),
    });
    const system = makeSystem({ masses: Float64Array.of(1, 1), c: 1, forces: [tight] });
    const start = stateAtRest(Float64Array.of(0, 0, 0, 1, 0, 0));
    const order = { system, start, method: method('semi-implicit-euler-0'), duration: 1, every: 0.1, step: 0.05 };
    expect(stepSchedule(order).stable).toBe(true);
    const { frames, stop } = recordRun(order);
    expect(stop).toMatchObject({ reason: 'light', t: 0, point: 0 });
    expect(english(stop?.message)).toMatch(/^point \d+ goes at .* m\/s, not below c = 1 m\/s; take a smaller step$/);
    expect(frames).toHaveLength(1);
  });

  it('defaults to a tenth of the longest stable step', () => {
    const order = { ...hanging(8, 10), method: method('leapfrog'), duration: 0.02, every: 0.01 };
    const { h, stable } = stepSchedule(order);
    expect(h * maxAngularFrequency(order.system)).toBeLessThanOrEqual(0.2);
    expect(stable).toBe(true);
    expect(stepSchedule({ ...order, step: 1 }).perFrame).toBe(1);
  });

  it.each([
    [{ masses: Float64Array.of(1, 0) }, /point 1 has the mass 0 kg/],
    [{ masses: Float64Array.of(1), c: 0 }, /speed of light is 0/],
    [{ masses: Float64Array.of(1), drag: -1 }, /drag is -1/],
  ])('rejects invalid input: %o', (given: Partial<System> & Pick<System, 'masses'>, message) => {
    expect(() => makeSystem(given)).toThrow(message);
  });
});

describe('obstacles', () => {
  /** 1 kg thrown at a fixed sphere of radius 0.5 m with contact radius 0.55 m. */
  const thrown = (speed: number, stiffness: number, step: number): RunOptions => {
    const masses = Float64Array.of(1, 1);
    const pinned = Uint8Array.of(1, 0);
    const contacts = sphereContacts([{ point: 0, radius: 0.5 }], [1], { stiffness, scale: 1.1 });
    const system = makeSystem({ masses, pinned, c: 100, forces: [contacts] });
    const p = momenta(system, [0, 0, 0, speed, 0, 0]);
    const start = { t: 0, x: Float64Array.of(0, 0, 0, -2, 0.01, 0), p };
    return { system, start, method: method('leapfrog'), duration: 1, every: 0.1, step };
  };

  it('reflect slow points, and fast ones if stiff enough', () => {
    const { frames, stop } = recordRun(thrown(5, 10_000, 1e-3));
    expect(stop).toBeUndefined();
    expect(frames.at(-1)!.state.p[3]).toBeLessThan(0);
  });

  it.each([
    ['in one step', 50, 10_000, 0.05],
    ['in many steps, because they are soft', 5, 10, 1e-3],
  ])('stop the run if a point passes through one %s', (_, speed, stiffness, step) => {
    const { frames, stop } = recordRun(thrown(speed, stiffness, step));
    expect(stop).toMatchObject({ reason: 'pierced', point: 1 });
    expect(english(stop?.message)).toMatch(/^point 1 went through what is solid, to \(.+\) m; take a smaller step/);
    // ½K·0.55² = 1.5 J are less than ½·25 J: it passes half of the reach after 1.7 m at 5 m/s, or slightly later.
    expect(stop!.t).toBeGreaterThan(1.725 / speed);
    expect(stop!.t).toBeLessThan(2.2 / speed + step);
    expect(frames.at(-1)!.state.t).toBeLessThanOrEqual(stop!.t + 1e-9);
    expect(frames.at(-1)!.state.x[3]).toBeLessThan(0);
  });

  it('can be boxes, and do not affect points that pass beside them', () => {
    const system = makeSystem({
      masses: Float64Array.of(1, 1),
      c: 100,
      forces: [barrier(box([0, 0, 0], [1, 1, 1]), [0, 1], 10_000, 0.05)],
    });
    const p = momenta(system, [0, 50, 0, 0, 50, 0]);
    const order = { system, method: method('leapfrog'), duration: 1, every: 0.1, step: 0.05 };
    const beside = { t: 0, x: Float64Array.of(0.6, -1.2, 0, 0, -9, 0), p };
    expect(recordRun({ ...order, start: beside, duration: 0.1 }).stop).toBeUndefined();
    const through = { t: 0, x: Float64Array.of(0.6, -1.2, 0, 0, -1.2, 0), p };
    expect(recordRun({ ...order, start: through }).stop).toMatchObject({ reason: 'pierced', point: 1, t: 0.05 });
  });
});

/** Slope of a regression line through the means of consecutive parts, and its standard error, per part. */
function trend(values: readonly number[], parts: number): { readonly slope: number; readonly error: number } {
  const size = Math.floor(values.length / parts);
  const mean = (of: readonly number[]): number => of.reduce((sum, value) => sum + value, 0) / of.length;
  const means = Array.from({ length: parts }, (_, k) => mean(values.slice(k * size, (k + 1) * size)));
  const [middle, level] = [(parts - 1) / 2, mean(means)];
  const spread = means.reduce((sum, _, k) => sum + (k - middle) ** 2, 0);
  const slope = means.reduce((sum, value, k) => sum + (k - middle) * (value - level), 0) / spread;
  const left = means.reduce((sum, value, k) => sum + (value - level - slope * (k - middle)) ** 2, 0);
  return { slope, error: Math.sqrt(left / (parts - 2) / spread) };
}

// `npm run dynamics` tests the same with larger cloths and more steps.
describe('the energy of a cloth', () => {
  /**
   * A cloth whose points get random velocities up to `shaken` m/s along each axis: energy every 100 steps, relative to
   * the initial one, over the maximum kinetic energy.
   */
  const followed = (id: string, shaken: number, step: number, steps: number, seed = 3): number[] => {
    const { system, start } = hanging(4, 10);
    const next = random(seed);
    const p = momenta(
      system,
      Array.from(start.x, () => shaken * (2 * next() - 1)),
    );
    const order = { system, start: { ...start, p }, method: method(id), step, every: 100 * step };
    const { frames, stop } = recordRun({ ...order, duration: steps * step });
    expect(stop).toBeUndefined();
    const kinetic = Math.max(...frames.map(({ quantities }) => quantities.kinetic));
    return frames.map(({ quantities }) => (quantities.total - frames[0].quantities.total) / kinetic);
  };

  it('is conserved by the discrete gradient to 10⁻¹¹ over 10⁴ steps', () => {
    expect(Math.max(...followed('discrete-gradient', 3, 1e-3, 10_000).map(Math.abs))).toBeLessThan(1e-11);
  });

  it.each([
    ['leapfrog', 3e-3],
    ['yoshida-4', 3e-5],
  ])('oscillates by %s, by less than %s of the kinetic energy, without a trend after equipartition', (id, most) => {
    // Parts of one run are correlated: its slope is up to ten standard errors, of either sign. Runs are independent.
    const slopes = [1, 2, 3, 4, 5, 6].map((seed) => {
      const off = followed(id, 3, 5e-4, 60_000, seed);
      expect(Math.max(...off.map(Math.abs))).toBeLessThan(most);
      return trend(off.slice(off.length / 3), 20).slope;
    });
    const mean = slopes.reduce((sum, slope) => sum + slope, 0) / slopes.length;
    const square = slopes.reduce((sum, slope) => sum + (slope - mean) ** 2, 0);
    expect(Math.abs(mean)).toBeLessThan(3 * Math.sqrt(square / (slopes.length - 1) / slopes.length));
  });

  it('has a trend with methods that are not symplectic: it decays with linearly implicit steps', () => {
    const { slope, error } = trend(followed('linearly-implicit-0', 3, 5e-4, 10_000), 20);
    expect(slope).toBeLessThan(-3 * error);
  });
});

describe('adaptive steps', () => {
  /** Fly-by of two attracting charges; `aside`: impact parameter [m]. */
  const flyBy = (c: number, strength: number, aside: number): Pick<RunOptions, 'system' | 'start'> => {
    const forces = [coulomb(Float64Array.of(1, -1), strength)];
    const system = makeSystem({ masses: Float64Array.of(1, 1), c, forces });
    const p = momenta(system, [0.5, 0, 0, -0.5, 0, 0]);
    return { system, start: { t: 0, x: Float64Array.of(-4, aside, 0, 4, -aside, 0), p } };
  };
  /** Angle of the final velocity. */
  const turned = ({ state }: SimulationFrame): number => Math.atan2(state.p[1], state.p[0]);

  it('deflect a fly-by by Rutherford’s formula, where as many equal steps fail', () => {
    const order = { ...flyBy(Number.POSITIVE_INFINITY, 1, 0.05), method: method('yoshida-4'), duration: 8, every: 8 };
    const { frames, stop } = recordRun({ ...order, tolerance: 1e-5 });
    expect(stop).toBeUndefined();
    const end = hyperbola(order.start.x, order.start.p, frames[1].state);
    expect(end.off).toBeLessThan(1e-3);
    const equal = recordRun({ ...order, step: 8 / frames[1].steps });
    const blind = hyperbola(order.start.x, order.start.p, equal.frames[1].state);
    expect(blind.off).toBeGreaterThan(30 * end.off);
    expect(Math.abs(turned(frames[1]))).toBeGreaterThan(1);
  });

  it.each([
    ['leapfrog', 1],
    ['yoshida-4', 1],
    ['discrete-gradient', 1],
    ['implicit-midpoint', 2],
  ])('keep their tolerance for %s: over the steps of each second', (id, c) => {
    const { system, start } = flyBy(c, 0.3, 0.3);
    const tolerance = 1e-4;
    const mover = new Integrator(system, method(id));
    const adaptive = new AdaptiveSteps(mover, system, { order: method(id).order, tolerance, longest: 1 });
    const state = copyState(start);
    const exact = METHODS.get('yoshida-8')!.begin(system);
    const v = [new Float64Array(6), new Float64Array(6)];
    // Over so short a time the fly-by does not amplify earlier errors.
    for (let k = 0; k < 320; k++) {
      const before = copyState(state);
      adaptive.advance(state, 0.05);
      for (let i = 0; i < 1000; i++) exact.step(before, 0.05 / 1000);
      velocities(system, state.p, v[0]);
      velocities(system, before.p, v[1]);
      for (const [a, b] of [[state.x, before.x], v] as const)
        for (let j = 0; j < 6; j += 3)
          expect(Math.hypot(a[j] - b[j], a[j + 1] - b[j + 1], a[j + 2] - b[j + 2])).toBeLessThan(
            SLACK * 0.05 * tolerance,
          );
    }
  });

  it('stay below the stability bound, and resume from any frame to the same bits', () => {
    const order = { ...hanging(6, 10), method: method('leapfrog'), duration: 0.3, every: 0.05, tolerance: 10 };
    const omega = maxAngularFrequency(order.system);
    expect(stepSchedule(order).h * omega).toBeLessThan(2);
    const { frames, stop } = recordRun(order);
    expect(stop).toBeUndefined();
    const steps = frames.map(({ steps: each }) => each);
    for (let k = 1; k < frames.length; k++) expect(steps[k] - steps[k - 1]).toBeGreaterThanOrEqual((0.05 * omega) / 2);
    const again = recordRun({ ...order, start: frames[3].state, duration: 0.15 });
    expect(again.frames.at(-1)!.state.x).toEqual(frames.at(-1)!.state.x);
  });

  it('report where no step is short enough', () => {
    const { stop } = recordRun({
      ...flyBy(1, 0.3, 0.3),
      method: method('leapfrog'),
      duration: 1,
      every: 1,
      tolerance: 1e-300,
    });
    expect(stop?.reason).toBe('tolerance');
  });
});

/** Margin on bounds that are asymptotic in the step. */
const SLACK = 2;

/**
 * Distance of the first of two bodies from its position on Kepler's hyperbola at that time, over its distance: r = p/(1
 * + e cos θ) with reduced mass ½ and strength 1. The orbit follows from energy and angular momentum; the position from
 * Kepler's equation M = e sinh F − F.
 */
function hyperbola(x: Float64Array, p: Float64Array, end: { t: number; x: Float64Array }): { readonly off: number } {
  const [rx, ry] = [x[3] - x[0], x[4] - x[1]];
  const [vx, vy] = [p[3] - p[0], p[4] - p[1]];
  // r̈ = −μ r/r³ with μ = 1/m_red = 2.
  const mu = 2;
  const r = Math.hypot(rx, ry);
  const energy = (vx * vx + vy * vy) / 2 - mu / r;
  const a = mu / (2 * energy);
  const spin = rx * vy - ry * vx;
  const [ex, ey] = [(vy * spin) / mu - rx / r, (-vx * spin) / mu - ry / r];
  const e = Math.hypot(ex, ey);
  const n = Math.sqrt(mu / a ** 3);
  const F0 = Math.asinh((rx * vx + ry * vy) / Math.sqrt(mu * a) / e);
  const M = e * Math.sinh(F0) - F0 + n * end.t;
  let F = Math.asinh(M / e);
  for (let k = 0; k < 60; k++) F -= (e * Math.sinh(F) - F - M) / (e * Math.cosh(F) - 1);
  const along = a * (e - Math.cosh(F));
  const across = Math.sign(spin) * a * Math.sqrt(e * e - 1) * Math.sinh(F);
  const [ux, uy] = [ex / e, ey / e];
  const [wx, wy] = [along * ux - across * uy, along * uy + across * ux];
  const [fx, fy] = [end.x[3] - end.x[0], end.x[4] - end.x[1]];
  return { off: Math.hypot(fx - wx, fy - wy) / Math.hypot(wx, wy) };
}

describe('steps beyond the stability limit', () => {
  // A point on a spring with hω = 2.5, released 10 nm from rest: its amplitude is multiplied by λ with each step, λ² + (h²ω² − 2) λ + 1 = 0.
  const [mass, stiffness, h] = [1, 100, 0.25];
  const trace = 2 - h ** 2 * (stiffness / mass);
  const growth = (Math.abs(trace) + Math.sqrt(trace ** 2 - 4)) / 2;
  const spring = { ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(stiffness), lengths: Float64Array.of(1) };
  const masses = Float64Array.of(1e9, mass);
  const system = makeSystem({ masses, pinned: Uint8Array.of(1, 0), c: 1e6, forces: [springForce(spring)] });
  const start = stateAtRest(Float64Array.of(0, 0, 0, 1 + 1e-8, 0, 0));
  const order = { system, start, method: method('semi-implicit-euler-0'), duration: 40 * h, every: 10 * h, step: h };

  function ended(options: RunOptions) {
    const frames: SimulationFrame[] = [];
    const run = integrate(options);
    for (let next = run.next(); ; next = run.next()) {
      if (next.done) return { frames, stop: next.value };
      frames.push(next.value);
    }
  }

  it('end the run, with the last state before', () => {
    const { frames, stop } = ended(order);
    expect(frames).toHaveLength(1);
    expect(stop).toMatchObject({ reason: 'unstable', last: { t: expect.closeTo(10 * h, 12) } });
    const [after] = ended({ ...order, duration: 10 * h, evenUnstable: true }).frames.slice(-1);
    expect([...stop!.last!.x]).toEqual([...after!.state.x]);
  });

  it('show how it explodes where that is wanted: the amplitude grows by λ with each step', () => {
    const { frames, stop } = ended({ ...order, every: h, duration: 12 * h, evenUnstable: true });
    expect(stop).toBeUndefined();
    const x = frames.map(({ state }) => state.x[3]! - 1);
    for (let k = 6; k < 10; k++) expect(x[k + 1]! / x[k]!).toBeCloseTo(-growth, 3);
  });

  it('end where a point would reach c all the same', () => {
    const { frames, stop } = ended({ ...order, every: h, duration: 40 * h, evenUnstable: true });
    expect(stop).toMatchObject({ reason: 'light', point: 1 });
    expect(frames.at(-1)!.quantities.fastest).toBeLessThan(1e6);
    expect(stop!.last!.t).toBeCloseTo(frames.at(-1)!.state.t, 9);
  });
});
