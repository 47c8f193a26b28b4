import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type HeadlessDevice, openDevice } from '../../../src/cli/gpu/device.ts';
import { runOnGpu } from '../../../src/compute/runOnGpu.ts';
import { barrier } from '../../../src/dynamics/forces/barrier.ts';
import { PenaltyPotential, sphereContacts } from '../../../src/dynamics/forces/contact.ts';
import { coulomb } from '../../../src/dynamics/forces/coulomb.ts';
import { NeighborPairs } from '../../../src/dynamics/forces/neighborPairs.ts';
import { box, plane } from '../../../src/dynamics/forces/obstacle.ts';
import { type Springs, springForce } from '../../../src/dynamics/forces/springs.ts';
import { uniformField } from '../../../src/dynamics/forces/uniformField.ts';
import { meshSprings } from '../../../src/dynamics/meshSprings.ts';
import { METHODS } from '../../../src/dynamics/methods/library.ts';
import type { RunOptions, SimulationFrame } from '../../../src/dynamics/run.ts';
import { makeSystem, momenta, type System, SystemError } from '../../../src/dynamics/system.ts';
import { fromAxisAngle } from '../../../src/math/quat.ts';
import { random } from '../../../src/math/random.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { type RecordedRun, recordRun, sheet } from '../../support/clothKit.ts';

let gpu: HeadlessDevice;
beforeAll(async () => {
  gpu = await openDevice();
});
afterAll(() => {
  gpu.assertHealthy();
  gpu.release();
});

async function onGpu(runOptions: RunOptions): Promise<RecordedRun> {
  const frames: SimulationFrame[] = [];
  const running = runOnGpu(gpu.device, runOptions);
  for (;;) {
    const { done, value } = await running.next();
    if (done) return { frames, stop: value };
    frames.push(value);
  }
}

/** A sheet with springs. `at`: position of its first corner. */
function cloth(side: number, at: Vec3, k: number): { readonly x: Float64Array; readonly net: Springs } {
  const { x, faces } = sheet(side, at);
  return { x, net: meshSprings(x, faces, { structural: k, shear: k, bending: k }) };
}

const GRAVITY: Vec3 = [0, -9.8, 0];
/** Interval between frames [s], and their number. */
const [EVERY, FRAMES] = [0.02, 6];
const runOptions = (
  system: System,
  x: ArrayLike<number>,
  v: ArrayLike<number>,
  method: string,
  step: number,
): RunOptions => ({
  system,
  start: { t: 0, x: Float64Array.from(x), p: momenta(system, v) },
  method: METHODS.get(method)!,
  duration: EVERY * FRAMES,
  every: EVERY,
  step,
});
const still = (x: ArrayLike<number>): number[] => new Array(x.length).fill(0);

/** Ten by ten points of 10 g, hanging from two corners. */
function hanging(method: string, step = 2e-4): RunOptions {
  const { x, net } = cloth(10, [0, 0, 0], 1000);
  const masses = new Float64Array(100).fill(0.01);
  const pinned = new Uint8Array(100);
  pinned[0] = pinned[9] = 1;
  const system = makeSystem({ masses, pinned, c: 10, forces: [springForce(net), uniformField(masses, GRAVITY)] });
  return runOptions(system, x, still(x), method, step);
}

/** A cloth, a ball thrown onto it and a fixed one below it; the rows of the balls are long. */
function ballsAndCloth(): RunOptions {
  const { x, net } = cloth(10, [0, 0, 0], 500);
  const masses = Float64Array.of(...new Array(100).fill(0.01), 1, 1);
  const pinned = new Uint8Array(102);
  pinned[101] = 1;
  const points = Array.from({ length: 100 }, (_, i) => i);
  const balls = [
    { point: 100, radius: 0.2 },
    { point: 101, radius: 0.15 },
  ];
  const forces = [springForce(net), sphereContacts(balls, points), uniformField(masses, GRAVITY)];
  const places = [...x, 0.5, 0.25, 0.4, 0.45, -0.18, 0.5];
  const v = still(places).map((_, j) => (j === 301 ? -3 : 0));
  return runOptions(makeSystem({ masses, pinned, c: 20, forces }), places, v, 'leapfrog', 2e-4);
}

/** A cloth falling through air between a rotated box and a slanted plane. */
function clothOnObstacles(): RunOptions {
  const { x, net } = cloth(10, [0, 0.03, 0], 500);
  const masses = new Float64Array(100).fill(0.01);
  const points = Array.from({ length: 100 }, (_, i) => i);
  const block = box([0.3, -0.2, 0.5], [0.5, 0.3, 0.6], fromAxisAngle([1, 2, -1], 0.7));
  const slope = plane([0.9, -0.05, 0.5], [-0.3, 1, 0.2]);
  const forces = [
    springForce(net),
    uniformField(masses, GRAVITY),
    barrier(block, points, 3000, 0.01),
    barrier(slope, points, 2000, 0.02),
  ];
  return runOptions(makeSystem({ masses, c: 15, drag: 0.5, forces }), x, still(x), 'leapfrog', 2e-4);
}

/** Two sheets that pass within contact distance; `speed`: of each. */
function sheetsThatTouch(speed: number): RunOptions {
  const [a, b] = [cloth(8, [0, 0, 0], 200), cloth(8, [0.05, 0.1, 0.03], 200)];
  const ends = [...a.net.ends, ...a.net.ends.map((end) => end + 64)];
  const both = (values: Float64Array): Float64Array => Float64Array.of(...values, ...values);
  const net = { ends: Uint32Array.from(ends), stiffness: both(a.net.stiffness), lengths: both(a.net.lengths) };
  const masses = new Float64Array(128).fill(0.01);
  const bodies = Int32Array.from(masses, (_, i) => Number(i >= 64));
  const forces = [
    springForce(net),
    new NeighborPairs(bodies, Float64Array.from([...a.x, ...b.x]), 0.06, new PenaltyPotential(300, () => 0.06)),
  ];
  const x = [...a.x, ...b.x];
  const v = x.map((_, j) => (j % 3 === 1 ? (j < 192 ? speed : -speed) : 0));
  return runOptions(makeSystem({ masses, c: 30, forces }), x, v, 'leapfrog', 1e-4);
}

/** Charges in a magnetic field [T] and an electric one. */
function swarm(magneticField: Vec3): RunOptions {
  const next = random(7);
  const x = Array.from({ length: 240 }, () => next() - 0.5);
  const masses = new Float64Array(80).fill(1e-3);
  const charges = Float64Array.from(masses, (_, i) => (i % 3) - 1 || 0);
  const forces = [coulomb(charges, 1e-5), uniformField(charges, [2e-3, 0, 1e-3])];
  const system = makeSystem({ masses, charges, c: 2, magneticField, forces });
  const v = x.map(() => 2 * (next() - 0.5));
  return runOptions(system, x, v, 'yoshida-4', 5e-4);
}

const CASES: readonly (readonly [string, () => RunOptions])[] = [
  ['a cloth that hangs, by leapfrog', () => hanging('leapfrog')],
  ['a cloth that hangs, by Yoshida’s method of order 8', () => hanging('yoshida-8', 1e-3)],
  ['a ball that is thrown onto a cloth', ballsAndCloth],
  ['a cloth that falls on a box and a plane, in air', clothOnObstacles],
  ['sheets that touch', () => sheetsThatTouch(1)],
  ['sheets that touch so fast that who is near changes at once', () => sheetsThatTouch(9)],
  ['charges in a magnetic field', () => swarm([0.01, -0.02, 0.03])],
  ['charges that turn through many radians in each step', () => swarm([3, -6, 9])],
];

describe.each(CASES)('%s', (_, of) => {
  it('moves as in 64 bits, with an energy error of at most four millionths of the kinetic energy', async () => {
    const [found, truth] = [await onGpu(of()), recordRun(of())];
    expect(found.stop).toBeUndefined();
    expect(found.frames).toHaveLength(FRAMES + 1);
    const scale = Math.max(...truth.frames.map(({ quantities }) => quantities.kinetic));
    found.frames.forEach(({ state, quantities, steps }, k) => {
      const { state: right, quantities: books, steps: taken } = truth.frames[k];
      expect(steps).toBe(taken);
      const off = state.x.reduce((most, value, j) => Math.max(most, Math.abs(value - right.x[j])), 0);
      expect(off, `frame ${k}`).toBeLessThan(5e-6);
      expect(Math.abs(quantities.total - books.total) / scale, `frame ${k}`).toBeLessThan(4e-6);
    });
    // Every part has moved.
    const [first, last] = [truth.frames[0].state.x, truth.frames.at(-1)!.state.x];
    expect(Math.max(...last.map((value, j) => Math.abs(value - first[j])))).toBeGreaterThan(0.02);
  });
});

it('a constant force gives hyperbolic motion, up to γ = 50', async () => {
  const masses = Float64Array.of(2, 2);
  const [force, c] = [30, 1];
  const system = makeSystem({ masses, c, forces: [uniformField(Float64Array.of(1, 1), [force, 0, 0])] });
  const { frames } = await onGpu({
    ...runOptions(system, [0, 0, 0, 0, 1, 0], still([0, 0, 0, 0, 0, 0]), 'leapfrog', 1e-3),
    ...{ duration: 3.3, every: 0.3 },
  });
  const b = (masses[0] * c * c) / force;
  for (const { state, quantities } of frames) {
    const x = Math.sqrt(b * b + (c * state.t) ** 2) - b;
    expect(state.x[0]).toBeCloseTo(x, 5);
    expect(quantities.fastest).toBeLessThan(c);
    expect(Math.abs(state.p[0] - force * state.t)).toBeLessThanOrEqual(3e-6 * force * state.t);
  }
  expect(frames.at(-1)!.quantities.kinetic / (2 * masses[0] * c * c)).toBeGreaterThan(48);
});

it('is deterministic to the bit, also when resumed from a frame', async () => {
  const whole = await onGpu(sheetsThatTouch(3));
  const from = whole.frames[2];
  expect((await onGpu({ ...sheetsThatTouch(3), duration: EVERY * 2 })).frames).toEqual(whole.frames.slice(0, 3));
  const rest = await onGpu({ ...sheetsThatTouch(3), start: from.state, duration: EVERY * (FRAMES - 2) });
  rest.frames.forEach(({ state }, k) => {
    expect(state.x).toEqual(whole.frames[k + 2].state.x);
    expect(state.p).toEqual(whole.frames[k + 2].state.p);
  });
});

describe('a failing run', () => {
  const shot = (forces: System['forces'], more: Partial<System> = {}): RunOptions => {
    const masses = Float64Array.of(1, 1);
    const system = makeSystem({ masses, c: 100, forces, ...more });
    return runOptions(system, [-0.55, 0, 0, 0, 0, 0.02], [50, 0, 0, 0, 0, 0], 'leapfrog', 0.01);
  };
  const pinned = Uint8Array.of(0, 1);

  it.each([
    ['a box', () => shot([barrier(box([0, 0, 0], [0.2, 1, 1]), [0], 1000)])],
    ['a ball', () => shot([sphereContacts([{ point: 1, radius: 0.2 }], [0])], { pinned })],
  ])('ends if a point passes through %s, with the last valid frame', async (_, of) => {
    const { frames, stop } = await onGpu(of());
    expect(stop).toMatchObject({ reason: 'pierced', point: 0 });
    expect(recordRun(of()).stop).toMatchObject({ reason: 'pierced' });
    expect(frames.length).toBeGreaterThan(0);
    expect(frames.length).toBeLessThan(FRAMES);
  });

  it('ends if steps are too long', async () => {
    expect((await onGpu(hanging('leapfrog', 0.01))).stop?.reason).toMatch(/unstable|infinite/);
  });

  it('ends if the GPU is lost, with the frames computed so far', async () => {
    const mine = await openDevice();
    const running = runOnGpu(mine.device, hanging('leapfrog'));
    await running.next();
    await running.next();
    mine.device.destroy();
    expect(await running.next()).toMatchObject({ done: true, value: { reason: 'lost' } });
    mine.release();
  });

  it('rejects what a GPU cannot compute, and systems that are too large', async () => {
    const refused = async (of: RunOptions, device = gpu.device) => {
      await expect(runOnGpu(device, of).next()).rejects.toThrow(SystemError);
      return runOnGpu(device, of)
        .next()
        .catch(({ message }) => message);
    };
    expect(await refused(hanging('discrete-gradient'))).toContain('discrete-gradient is not computed on the GPU');
    expect(await refused({ ...hanging('leapfrog'), tolerance: 1e-6 })).toContain('adaptive steps');
    const masses = Float64Array.of(1);
    const led = makeSystem({
      masses,
      pinned: Uint8Array.of(1),
      kinematic: [{ point: 0, positionAt: (t) => [t, 0, 0] }],
    });
    expect(await refused(runOptions(led, [0, 0, 0], [0, 0, 0], 'leapfrog', 0.01))).toContain('prescribed motion');
    const small = new Proxy(gpu.device, {
      get(device, name) {
        if (name === 'limits') return { maxStorageBufferBindingSize: 4096, maxBufferSize: 4096 };
        const value = Reflect.get(device, name, device);
        return typeof value === 'function' ? value.bind(device) : value;
      },
    });
    expect(await refused(hanging('leapfrog'), small)).toMatch(/takes a buffer of 1 MiB/);
  });
});
