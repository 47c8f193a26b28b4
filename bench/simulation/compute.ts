import { GpuIntegrator } from '../../src/compute/gpuIntegrator.ts';
import { runOnGpu } from '../../src/compute/runOnGpu.ts';
import { METHODS } from '../../src/dynamics/methods/library.ts';
import { integrate, type RunOptions } from '../../src/dynamics/run.ts';
import { copyState } from '../../src/dynamics/system.ts';
import { type Bench, interleaved, type Table } from '../support/bench.ts';
import { gpu } from '../support/gpu.ts';
import { cloth, massFor, STEP } from './dynamics.ts';

/** Points along a side, and hω of a step of 1/240 s, as in dynamics.ts. */
const SIDES = [32, 100, 316];
const STIFF = [6, 64];
/** Maximum of points × steps for a software adapter. */
const MAX_SOFTWARE = 700_000;
const ROUNDS = 3;
const LEAPFROG = METHODS.get('leapfrog')!;
/** The cloth whose energy is compared: points along a side, and the mass of each [kg]. */
const [SIDE, MASS] = [10, 0.01];
/** Methods with step [s] and number of steps. With the longer steps the rounding of 32 bits shows beside the method's error. */
const FOLLOWED = [
  ['leapfrog', 2.5e-4, 100_000],
  ['yoshida-6', 5e-4, 1_000],
  ['yoshida-6', 5e-4, 10_000],
] as const;
const FRAMES = 500;

export const computing: Bench = {
  name: 'compute',
  title: 'Relativistic cloth on the GPU',
  about:
    'The cloth of the benchmark before, by leapfrog, in steps of hω ≤ 1: in 64 bits in one thread, and by WebGPU in 32 bits, with all that goes to the GPU and comes back. Both take turns. Times are those of a clock.',
  async run() {
    return [await times(), await energies()];
  },
};

async function times(): Promise<Table> {
  const { device, adapterName, software } = await gpu();
  const rows: (string | number)[][] = [];
  for (const side of SIDES)
    for (const stiff of STIFF) {
      if (software && side * side * stiff > MAX_SOFTWARE) continue;
      const { system, start } = cloth(side, massFor(side, stiff));
      const machine = await GpuIntegrator.create(device, system, LEAPFROG.coefficients!, STEP / stiff);
      const stepper = LEAPFROG.begin(system);
      const [there, here] = [copyState(start), copyState(start)];
      const [slow, fast] = await interleaved(
        [() => stepper.steps!(here, STEP / stiff, stiff), () => machine.advance(there, stiff)],
        ROUNDS,
      );
      machine.release();
      const real = (ms: number): string => `**${((STEP * 1000) / ms).toPrecision(2)}**`;
      rows.push([
        (side * side).toLocaleString('en'),
        stiff,
        String(stiff),
        slow,
        fast,
        slow / fast,
        real(slow),
        real(fast),
      ]);
    }
  return {
    columns: [
      ...['points', 'hω', 'steps', '64 bits, one thread [ms]', 'GPU [ms]', 'thread ÷ GPU'],
      ...['thread: × real time', 'GPU: × real time'],
    ],
    rows,
    remark: `The GPU: ${adapterName}. Times are of 1/240 s of motion.${software ? ' It is a program that does a GPU’s work on the processor; what a GPU gains is to be seen where there is one.' : ''}`,
  };
}

/** Largest deviation of the energy from its initial value, over the largest kinetic energy. */
async function energies(): Promise<Table> {
  const { device } = await gpu();
  const { system, start } = cloth(SIDE, MASS);
  const rows: string[][] = [];
  for (const [id, step, steps] of FOLLOWED) {
    const duration = steps * step;
    const options: RunOptions = { system, start, method: METHODS.get(id)!, duration, every: duration / FRAMES, step };
    const truth = [...integrate(options)].map(({ quantities }) => quantities);
    const kinetic = Math.max(...truth.map((each) => each.kinetic));
    const found: number[] = [];
    for await (const { quantities } of runOnGpu(device, options)) found.push(quantities.total);
    const most = (energies: readonly number[]): string =>
      (Math.max(...energies.map((energy) => Math.abs(energy - truth[0].total))) / kinetic).toExponential(1);
    rows.push([
      id,
      `${step * 1000} ms`,
      steps.toLocaleString('en'),
      most(truth.map(({ total }) => total)),
      most(found),
    ]);
  }
  return {
    columns: ['method', 'h', 'steps', '64 bits: energy off', 'GPU: energy off'],
    rows,
    remark: `${SIDE} × ${SIDE} points of ${MASS * 1000} g that hang at two corners and are let go level; at most, over the largest kinetic energy.`,
  };
}
