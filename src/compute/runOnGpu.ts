import {
  type EarlyStop,
  earlyStopFor,
  FrameBuilder,
  NO_STEPS,
  type RunOptions,
  type SimulationFrame,
} from '../dynamics/run.ts';
import { copyState, SystemError } from '../dynamics/system.ts';
import { msg } from '../messages/message.ts';
import { GpuIntegrator } from './gpuIntegrator.ts';

/**
 * As `integrate` of dynamics, with steps on a GPU, in 32-bit floats (docs/adr/0020-cloth-on-the-gpu.md). Splitting
 * methods with fixed steps only; energies and momenta are summed on the CPU in 64 bits. The device is not closed.
 * Throws a SystemError for what a GPU cannot compute.
 * @example
 * import { METHODS, type RunOptions } from 'slowlight/dynamics';
 * async function simulate(options: RunOptions) {
 *   const { device, release } = await openWebGpu();
 *   for await (const { state, quantities } of runOnGpu(device, options)) console.log(state.t, quantities.total);
 *   release();
 * }
 */
export async function* runOnGpu(
  device: GPUDevice,
  options: RunOptions,
): AsyncGenerator<SimulationFrame, EarlyStop | undefined> {
  const { system, method, tolerance, start, since } = options;
  if (!method.coefficients)
    throw new SystemError(msg`${method.id} is not computed on the GPU; leapfrog and Yoshida's methods are`);
  if (tolerance !== undefined) throw new SystemError(msg`adaptive steps are not supported on the GPU; use fixed steps`);
  const course = new FrameBuilder(options);
  const { h, perFrame } = course.steps;
  const machine = await withErrorScopes(device, () => GpuIntegrator.create(device, system, method.coefficients!, h));
  try {
    const state = copyState(start);
    let { steps } = since?.tally ?? NO_STEPS;
    yield course.start();
    while (!course.isDone) {
      let frame: SimulationFrame;
      try {
        await machine.advance(state, perFrame);
        steps += perFrame;
        // The energy that drag takes is not summed on the GPU.
        frame = course.next(state, { steps, ...(system.drag === 0 && { dragLoss: 0 }) });
      } catch (error) {
        return earlyStopFor(error, state.t);
      }
      yield frame;
    }
    return undefined;
  } finally {
    machine.release();
  }
}

/** Runs GPU calls within error scopes; throws if the GPU refuses, e.g. for lack of memory. */
async function withErrorScopes<T>(device: GPUDevice, make: () => Promise<T>): Promise<T> {
  const kinds = ['validation', 'out-of-memory', 'internal'] as const;
  for (const kind of kinds) device.pushErrorScope(kind);
  const [result] = await Promise.allSettled([make()]);
  const errors = await Promise.all(kinds.map(() => device.popErrorScope()));
  if (result.status === 'rejected') throw result.reason;
  const refused = errors.find((error) => error !== null);
  if (refused) throw new SystemError(msg`the GPU refuses: ${refused.message}`);
  return result.value;
}
