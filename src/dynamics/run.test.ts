import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { uniform as between } from '../../tests/physicsArbitraries.ts';
import { random } from '../math/random.ts';
import { Penalty } from './forces/contact.ts';
import { NearPairs } from './forces/near.ts';
import { Pairs } from './forces/pairs.ts';
import { springs } from './forces/springs.ts';
import { uniform } from './forces/uniform.ts';
import { METHODS } from './methods/library.ts';
import { meshSprings } from './nets.ts';
import { type Frame, type Order, run, type Stop, stepsOf } from './run.ts';
import { fastestOscillation } from './stability.ts';
import { makeSystem, restingAt, type System, SystemError } from './system.ts';

/** n × n points of a cloth of a metre, in the plane y = 0, by quads. */
function cloth(n: number) {
  const x = new Float64Array(3 * n * n);
  const corners: number[] = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < n; j++) {
      x.set([j / (n - 1), 0, i / (n - 1)], 3 * (i * n + j));
      if (i + 1 < n && j + 1 < n) corners.push(i * n + j, i * n + j + 1, (i + 1) * n + j + 1, (i + 1) * n + j);
    }
  return { x, faces: { counts: new Array((n - 1) ** 2).fill(4), corners } };
}

function hanging(n: number, c: number, drag = 0): Pick<Order, 'system' | 'start'> {
  const { x, faces } = cloth(n);
  const masses = new Float64Array(n * n).fill(1 / (n * n));
  const pinned = new Uint8Array(n * n);
  pinned[0] = pinned[n - 1] = 1;
  const net = springs(meshSprings(x, faces, { structural: 1000, shear: 1000, bending: 1000 }));
  return {
    system: makeSystem({ masses, pinned, c, drag, forces: [net, uniform(masses, [0, -9.8, 0])] }),
    start: restingAt(x),
  };
}

function whole(order: Order): { readonly frames: readonly Frame[]; readonly stop: Stop | undefined } {
  const frames: Frame[] = [];
  const running = run(order);
  for (let next = running.next(); ; next = running.next()) {
    if (next.done) return { frames, stop: next.value };
    frames.push(next.value);
  }
}

const method = (id: string) => METHODS.get(id)!;

describe('springs of a mesh', () => {
  it('are along edges, across faces, and to the next neighbour: each once, as long as at rest', () => {
    const n = 5;
    const { x, faces } = cloth(n);
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

  it('bend over the edges between triangles, and refuse faces of points that are not there', () => {
    const x = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
    const two = { counts: [3, 3], corners: [0, 1, 2, 1, 3, 2] };
    const { ends } = meshSprings(x, two, { structural: 0, shear: 1, bending: 1 });
    expect([...ends]).toEqual([0, 3]);
    expect(() => meshSprings(x, { counts: [3], corners: [0, 1, 7] }, { structural: 1, shear: 0, bending: 0 })).toThrow(
      SystemError,
    );
  });
});

describe('points that are near', () => {
  it('are those of all pairs that are within reach, wherever they have gone since they were sought', () => {
    const n = 60;
    const next = random(5);
    const bodies = Int32Array.from({ length: n }, (_, i) => (i % 4) - 1);
    const law = new Penalty(10, () => 0.3);
    const near = new NearPairs(bodies, 0.3, law);
    const all = new Pairs(
      Uint32Array.from(
        Array.from({ length: n * n }, (_, k) => [Math.floor(k / n), k % n])
          .filter(([i, j]) => i < j && bodies[i] >= 0 && bodies[j] >= 0 && bodies[i] !== bodies[j])
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
        force.addMean(x, to, sum);
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

describe('the fastest oscillation', () => {
  it('is never faster than the bound: leapfrog below it is stable, and the chain nears it', () => {
    fc.assert(
      fc.property(between(0.1, 10), between(1, 1000), (m, k) => {
        const n = 30;
        const ends = Uint32Array.from({ length: 2 * (n - 1) }, (_, i) => (i + 1) >> 1);
        const system = makeSystem({
          masses: new Float64Array(n).fill(m),
          forces: [
            springs({ ends, stiffness: new Float64Array(n - 1).fill(k), lengths: new Float64Array(n - 1).fill(0.1) }),
          ],
        });
        // Of a long chain: 2√(k/m), and of n points that times cos(π/2n).
        const exact = 2 * Math.sqrt(k / m) * Math.cos(Math.PI / (2 * n));
        expect(fastestOscillation(system)).toBeGreaterThan(exact);
        expect(fastestOscillation(system)).toBeLessThan(1.01 * exact);
      }),
    );
  });
});

describe('a run', () => {
  it('gives frames at their times, with equal steps between them, and loses no energy', () => {
    const { frames, stop } = whole({
      ...hanging(6, 10),
      method: method('discrete-gradient'),
      duration: 0.5,
      every: 0.1,
      step: 0.011,
    });
    expect(stop).toBeUndefined();
    expect(frames.map(({ state }) => state.t)).toEqual([0, 0.1, 0.2, 0.30000000000000004, 0.4, 0.5]);
    expect(frames.map(({ steps }) => steps)).toEqual([0, 10, 20, 30, 40, 50]);
    const total = frames.map(({ ledger }) => ledger.total);
    const kinetic = Math.max(...frames.map(({ ledger }) => ledger.kinetic));
    expect(Math.max(...total) - Math.min(...total)).toBeLessThan(1e-11 * kinetic);
  });

  it('is the same each time, and when it is taken up again from a frame', () => {
    const order = { ...hanging(5, 5), method: method('leapfrog'), every: 0.05 };
    const { frames } = whole({ ...order, duration: 0.4 });
    const again = whole({ ...order, start: frames[4].state, duration: 0.2 });
    expect(again.frames.at(-1)!.state.x).toEqual(frames.at(-1)!.state.x);
    expect(again.frames.at(-1)!.state.p).toEqual(frames.at(-1)!.state.p);
  });

  it('loses to the air what it should: p falls as exp(−drag t)', () => {
    const system = makeSystem({ masses: Float64Array.of(2), c: 3, drag: 0.7 });
    const start = { t: 0, x: new Float64Array(3), p: Float64Array.of(5, 0, 0) };
    const { frames } = whole({ system, start, method: method('leapfrog'), duration: 2, every: 1 });
    expect(frames[2].state.p[0]).toBeCloseTo(5 * Math.exp(-1.4), 12);
  });

  it('stops with its last good state where the method of the sources explodes, and says why', () => {
    const order = { ...hanging(8, 10), method: method('semi-implicit-euler-0'), duration: 5, every: 0.02, step: 0.01 };
    expect(stepsOf(order).stable).toBe(false);
    const { frames, stop } = whole(order);
    expect(stop?.reason).toBe('light');
    expect(stop?.message).toMatch(/^point \d+ goes at .* m\/s, not below c = 10 m\/s; take a smaller step$/);
    expect(frames.at(-1)!.state.x.every(Number.isFinite)).toBe(true);
    expect(frames.length).toBeLessThan(250);
  });

  it('takes a tenth of the longest stable step where nobody says how long', () => {
    const order = { ...hanging(8, 10), method: method('leapfrog'), duration: 0.02, every: 0.01 };
    const { h, stable } = stepsOf(order);
    expect(h * fastestOscillation(order.system)).toBeLessThanOrEqual(0.2);
    expect(stable).toBe(true);
    expect(stepsOf({ ...order, step: 1 }).perFrame).toBe(1);
  });

  it.each([
    [{ masses: Float64Array.of(1, 0) }, /point 1 has the mass 0 kg/],
    [{ masses: Float64Array.of(1), c: 0 }, /speed of light is 0/],
    [{ masses: Float64Array.of(1), drag: -1 }, /drag is -1/],
  ])('refuses what cannot be moved: %o', (given: Partial<System> & Pick<System, 'masses'>, message) => {
    expect(() => makeSystem(given)).toThrow(message);
  });
});
