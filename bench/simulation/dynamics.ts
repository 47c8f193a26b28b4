import { teamThreads } from '../../src/cli/simulate/teamThreads.ts';
import { conservedQuantities } from '../../src/dynamics/energy.ts';
import { springForce } from '../../src/dynamics/forces/springs.ts';
import { uniformField } from '../../src/dynamics/forces/uniformField.ts';
import { meshSprings } from '../../src/dynamics/meshSprings.ts';
import { METHODS } from '../../src/dynamics/methods/library.ts';
import { maxAngularFrequency } from '../../src/dynamics/stability.ts';
import { copyState, makeSystem, type State, type System, stateAtRest } from '../../src/dynamics/system.ts';
import { MIN_POINTS, ThreadTeam } from '../../src/dynamics/threads/threadTeam.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { sheet } from '../../tests/support/clothKit.ts';
import { type Bench, cpuTimed, median, type Table, timed } from '../support/bench.ts';
import { inChild } from '../support/inChild.ts';
import { PlainCloth } from './plainCloth.ts';

/** Points along a side. */
const SIDES = [32, 100, 316];
/** hω of a step of 1/240 s. With 1000 N/m a point has 2.6 kg, 12 g or 0.1 g; a cloth of 10,000 points and 1 kg has 0.04, 9 or 1000 N/m. */
const STIFF = [0.4, 6, 64];
/** [s] */
export const STEP = 1 / 240;
/** Explicit methods take steps of hω = 1, half of the stability limit. */
const EXPLICIT = 1;
const ROUNDS = 5;
/** Points × steps of 1/240 s per round. */
const WORK = 50_000;
/** Steps of explicit methods before the first round, until V8 has compiled for good what each does; they take as long whatever the cloth does. */
const WARM_UP = 2500;
/** Larger cases are skipped: they would take minutes, with the same result. */
const MAX_WORK = 1_000_000;
/** [m/s], [m/s²], [N/m] */
const [C, GRAVITY, K]: readonly [number, Vec3, number] = [10, [0, -9.8, 0], 1000];
const PLAIN = 'as in the sources';
const COMPARED = [PLAIN, 'leapfrog', 'yoshida-4', 'discrete-gradient'];
const STEPPED_AT_ONCE: ReadonlySet<string> = new Set(['leapfrog', 'yoshida-4']);
/** Threads of the last column, where a run would take as many. */
const TEAM = 2;

/** What a child process measures. */
export interface ClothTask {
  readonly side: number;
  readonly method: string;
}

/** A cloth that falls, and in how many threads. */
export interface FallTask extends ClothTask {
  /** Of a point [kg]. */
  readonly mass: number;
  /** Steps of 1/240 s. */
  readonly parts: number;
  readonly threads?: number;
}

/** What a step of 1/240 s takes. */
export interface FallTimes {
  /** By the processor's clock, of all threads [ms]. */
  readonly busy: number;
  /** By the clock on the wall [ms]. */
  readonly elapsed: number;
  /** Energy error over the kinetic energy. */
  readonly energyError: number;
}

export const dynamics: Bench = {
  name: 'dynamics',
  title: 'Relativistic cloth: real time and memory',
  about:
    'A square cloth of a metre that hangs at two corners, with springs of 1000 N/m along edges, across faces and to the next neighbour (six a point), c = 10 m/s. ' +
    'How hard it is to compute is hω: the fastest swing of its points in a step of 1/240 s, by the mass of a point (0.4: 2.6 kg; 6: 12 g; 64: 0.1 g, which is 1 kg of 10,000 points). ' +
    'Explicit methods take as many steps as hω ≤ 1 asks for, the discrete gradient takes one, and keeps the energy to rounding. ' +
    '“As in the sources”: semi-implicit Euler on velocities with (I − ββᵀ) for each point, written plainly, with as many steps. Each in a process of its own, in one thread, by the processor’s time, ' +
    `as a simulation runs after its first second; leapfrog also in ${TEAM} threads, by the clock, of which each needs a processor of its own.`,
  async run() {
    return [times(), memory()];
  },
};

function times(): Table {
  const rows: (string | number)[][] = [];
  let energyError = 0;
  for (const side of SIDES)
    for (const stiff of STIFF) {
      const mass = massFor(side, stiff);
      const explicit = Math.ceil(stiff / EXPLICIT);
      if (side * side * explicit > MAX_WORK) continue;
      const timesOf = (method: string, threads?: number): FallTimes => {
        const parts = bounded(method) ? explicit : 1;
        return inChild('fall', JSON.stringify({ side, mass, method, parts, threads } satisfies FallTask));
      };
      const alone = COMPARED.map((method) => timesOf(method));
      const together = side * side < TEAM * MIN_POINTS ? Number.NaN : timesOf('leapfrog', TEAM).elapsed;
      const ms = [...alone.map(({ busy }) => busy), together];
      energyError = Math.max(energyError, alone[COMPARED.indexOf('discrete-gradient')].energyError);
      rows.push([
        (side * side).toLocaleString('en'),
        stiff,
        String(explicit),
        ...ms,
        ms[0] / ms[1],
        ...ms.slice(1).map((each) => (each > 0 ? `**${Number(((STEP * 1000) / each).toPrecision(2))}**` : '–')),
      ]);
    }
  const names = [...COMPARED, `leapfrog, ${TEAM} threads`];
  return {
    columns: [
      'points',
      'hω',
      'explicit steps',
      ...names.map((name) => `${name} [ms]`),
      'sources ÷ leapfrog',
      ...names.slice(1).map((name) => `${name}: × real time`),
    ],
    rows,
    remark: `Times are of 1/240 s of motion, with the steps that this takes; above 1 × it is faster than real time. The discrete gradient’s energy was off by ${energyError.toExponential(0)} of the kinetic energy at most.`,
  };
}

function memory(): Table {
  const rows = SIDES.map((side) => [
    (side * side).toLocaleString('en'),
    ...COMPARED.map((method) => inChild<{ bytes: number }>('dynamics', JSON.stringify({ side, method })).bytes),
  ]);
  return {
    columns: ['points', ...COMPARED.map((method) => `${method} [MiB]`), 'discrete gradient, bytes a point'],
    rows: rows.map(([points, ...bytes], i) => [
      points,
      ...bytes.map((each) => Number(each) / 2 ** 20),
      Number(bytes.at(-1)) / SIDES[i] ** 2,
    ]),
    remark:
      'Growth of resident memory, in a process of its own: the cloth, its springs, and the room a method works in.',
  };
}

const bounded = (method: string): boolean => METHODS.get(method)?.conditionallyStable ?? true;

/** Mass of a point [kg] for which a step has this hω. */
export function massFor(side: number, stiff: number): number {
  const omega = maxAngularFrequency(cloth(side, 1).system);
  return ((omega * STEP) / stiff) ** 2;
}

/** Measures one cloth, in this process. */
export async function measureFall(task: FallTask): Promise<FallTimes> {
  const { fall, energyError, release } = fallingBy(task);
  const frames = Math.max(1, Math.round(WORK / task.side ** 2));
  const round = (): void => {
    for (let i = 0; i < frames; i++) fall();
  };
  round();
  if (STEPPED_AT_ONCE.has(task.method)) for (let steps = 0; steps < WARM_UP; steps += task.parts) fall();
  const [busy, elapsed]: [number[], number[]] = [[], []];
  for (let i = 0; i < ROUNDS; i++) {
    elapsed.push((await timed(async () => void busy.push((await cpuTimed(round)) / frames))) / frames);
  }
  release();
  return { busy: median(busy), elapsed: median(elapsed), energyError: energyError() };
}

interface Falling {
  /** Advances the cloth by a step of 1/240 s, in substeps. */
  fall(): void;
  /** Energy error over the kinetic energy. */
  energyError(): number;
  /** Ends its threads. */
  release(): void;
}

export function fallingBy({ method: id, side, mass, parts, threads = 1 }: FallTask): Falling {
  const { system, net, start } = cloth(side, mass);
  if (id === PLAIN) {
    const plain = new PlainCloth(start.x, system.pinned, net, mass, GRAVITY, C);
    return {
      fall() {
        for (let i = 0; i < parts; i++) plain.step(STEP / parts);
      },
      energyError: () => Number.NaN,
      release: () => {},
    };
  }
  const team = threads > 1 ? new ThreadTeam(system, start, threads, teamThreads) : undefined;
  const state = team?.state ?? copyState(start);
  const stepper = METHODS.get(id)!.begin(system, team);
  const before = conservedQuantities(system, state).total;
  return {
    fall() {
      if (stepper.steps) stepper.steps(state, STEP / parts, parts);
      else for (let i = 0; i < parts; i++) stepper.step(state, STEP / parts);
    },
    energyError() {
      const { total, kinetic } = conservedQuantities(system, state);
      return Math.abs(total - before) / kinetic;
    },
    release: () => team?.release(),
  };
}

/** A square cloth of 1 m that hangs at two corners, with springs of 1000 N/m and c = 10 m/s. */
export function cloth(
  side: number,
  mass: number,
): { system: System; net: ReturnType<typeof meshSprings>; start: State } {
  const { x, faces } = sheet(side);
  const masses = new Float64Array(side * side).fill(mass);
  const pinned = new Uint8Array(side * side);
  pinned[0] = pinned[side - 1] = 1;
  const net = meshSprings(x, faces, { structural: K, shear: K, bending: K });
  const forces = [springForce(net), uniformField(masses, GRAVITY)];
  return { system: makeSystem({ masses, pinned, c: C, forces }), net, start: stateAtRest(x) };
}
