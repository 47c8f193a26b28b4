import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { defineNode } from '../defineNode.ts';
import type { RecordedMotion } from './motionRecorder.ts';
import { penaltyParam, quantityParam } from './params.ts';
import type { SimulationOutputs, SimulationSettings } from './simulation.ts';

/** The methods of the source documents, which have velocity corrections, are last. */
const METHODS = [
  { value: 'discrete-gradient', title: msg`Discrete gradient` },
  { value: 'implicit-midpoint', title: msg`Implicit midpoint` },
  { value: 'leapfrog', title: msg`Leapfrog` },
  { value: 'yoshida-4', title: msg`Yoshida 4` },
  { value: 'yoshida-6', title: msg`Yoshida 6` },
  { value: 'yoshida-8', title: msg`Yoshida 8` },
  { value: 'semi-implicit-euler', title: msg`Semi-implicit Euler` },
  { value: 'linearly-implicit', title: msg`Linearly implicit` },
  { value: 'local-global', title: msg`Local–global` },
];
const CORRECTED_METHODS = METHODS.slice(6).map(({ value }) => value);
/** Methods that run on the GPU. */
const SPLITTING_METHODS = METHODS.slice(2, 6).map(({ value }) => value);

const EXPLICIT_METHODS = [...SPLITTING_METHODS, 'semi-implicit-euler'];

/** Outside of a worker thread: interval at which it yields and checks for cancellation [ms]. */
const YIELD_INTERVAL = 50;

/** Computes how matter moves, and records its conserved quantities. */
export const simulateNode = defineNode({
  id: 'simulate',
  title: msg`Simulate`,
  help: msg`Computes how matter moves, with momenta as state, so that nothing reaches c, and records energy and momentum. The result moves along cubics between frames. “slowlight simulate PROJECT” does it on the command line.`,
  category: 'dynamics',
  heavy: true,
  onGpu: (params) => simulationSettings(params).onGpu,
  params: {
    speedOfLight: {
      kind: 'number',
      title: msg`Speed of light`,
      help: msg`The limiting speed; the scene then suggests it for viewing.`,
      unit: 'm/s',
      default: 10,
      min: 0.1,
      max: SPEED_OF_LIGHT,
      step: 0.1,
      scale: 'log',
    },
    mechanics: {
      kind: 'choice',
      title: msg`Mechanics`,
      help: msg`Newton’s mechanics is computed as if c were infinite, and may exceed the speed of light used for viewing.`,
      default: 'einstein',
      options: [
        { value: 'einstein', title: msg`Einstein’s` },
        { value: 'newton', title: msg`Newton’s` },
      ],
    },
    duration: quantityParam({ title: msg`Duration`, unit: 's', default: 4, min: 1e-6, max: 1e6 }),
    rate: quantityParam({
      title: msg`Frames per second`,
      help: msg`Number of recorded frames; steps are shorter.`,
      unit: '1/s',
      default: 24,
      min: 1e-3,
      max: 1e6,
    }),
    method: {
      kind: 'choice',
      title: msg`Method`,
      help: msg`The discrete gradient conserves energy; splitting methods are fast, and their energy oscillates without a trend; the last three are those of the source documents, for comparison.`,
      default: 'discrete-gradient',
      options: METHODS,
    },
    correction: {
      kind: 'choice',
      title: msg`Correction`,
      help: msg`Correction of the energy after each step. Tangent and secant apply a fraction of the change of velocity: they hold back steps that gain energy, and the secant leaves those that lose it, as implicit steps do. The root multiplies all momenta by the factor that conserves the energy to rounding; where there is none, the run ends.`,
      default: '0',
      options: [
        { value: '0', title: msg`None` },
        { value: '1', title: msg`By the tangent` },
        { value: '2', title: msg`By the secant` },
        { value: '3', title: msg`By the root` },
      ],
      onlyWhen: { param: 'method', is: CORRECTED_METHODS },
    },
    onGpu: {
      kind: 'boolean',
      title: msg`On the GPU`,
      help: msg`Takes the steps on the graphics processor, in 32-bit floats: for cloths of many thousands of points. Their rounding error is about a millionth of the kinetic energy.`,
      default: false,
      onlyWhen: { param: 'method', is: SPLITTING_METHODS },
    },
    tolerance: quantityParam({
      title: msg`Error per second`,
      help: msg`Steps adapt to keep the error of any position [m] and velocity [m/s] below this per second; 0: fixed steps.`,
      unit: 'm',
      default: 0,
      max: 1e6,
      step: 1e-6,
    }),
    step: quantityParam({
      title: msg`Step`,
      help: msg`Maximum step; 0: a tenth of the stability limit of an explicit method.`,
      unit: 's',
      default: 0,
      max: 1e6,
      step: 1e-6,
    }),
    evenUnstable: {
      kind: 'boolean',
      title: msg`Go on when unstable`,
      help: msg`Off: with steps that are too long for an explicit method, the run ends as soon as its energy grows. On: it shows how it explodes, until a point would reach c or go through what is solid.`,
      default: false,
      onlyWhen: { param: 'method', is: EXPLICIT_METHODS },
    },
    reach: quantityParam({
      title: msg`Contact distance`,
      help: msg`Points of nets that come nearer repel each other: between objects, and within an object that folds if they are farther apart at rest. About the length of an edge; 0: no contact.`,
      unit: 'm',
      default: 0,
    }),
    stiffness: penaltyParam,
  },
  inputs: { matter: { type: 'matter', many: true } },
  outputs: { geometry: { type: 'geometry' }, books: { type: 'books' } },
  async evaluate({ matter }, params, { node, services, progress, interim, resume, signal }) {
    // The page evaluates this in a worker, which loads the solver on demand.
    const { Simulation } = await import('./simulation.ts');
    const simulation = new Simulation(
      matter,
      simulationSettings(params),
      node,
      resume?.reel as RecordedMotion | undefined,
    );
    let lastYield = performance.now();
    for await (const _ of simulation.run(services)) {
      progress(simulation.recordedFrames / simulation.frames, 'simulate');
      interim?.(() => ({ ...simulation.outputs() }));
      if (signal && performance.now() - lastYield >= YIELD_INTERVAL) {
        await new Promise((resolve) => setTimeout(resolve));
        lastYield = performance.now();
      }
      if (signal?.aborted) throw new CancelledError();
    }
    const { geometry, books }: SimulationOutputs = simulation.outputs();
    return { geometry, books };
  },
});

/** Settings from the parameters; shared with the command line, which runs simulations itself. */
export function simulationSettings(params: Readonly<Record<string, unknown>>): SimulationSettings {
  const { method, correction, mechanics, onGpu, evenUnstable, reach, stiffness, ...rest } =
    params as unknown as SimulateParams;
  return {
    ...rest,
    method: CORRECTED_METHODS.includes(method) ? `${method}-${correction}` : method,
    newtonian: mechanics === 'newton',
    onGpu: onGpu && SPLITTING_METHODS.includes(method),
    evenUnstable: evenUnstable && EXPLICIT_METHODS.includes(method),
    touch: { reach, stiffness },
  };
}

interface SimulateParams
  extends Pick<
    SimulationSettings,
    'speedOfLight' | 'duration' | 'rate' | 'step' | 'tolerance' | 'method' | 'onGpu' | 'evenUnstable'
  > {
  readonly correction: string;
  readonly mechanics: string;
  readonly reach: number;
  readonly stiffness: number;
}
