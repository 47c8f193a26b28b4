import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { defineNode } from '../defineNode.ts';
import type { RecordedMotion } from './motionRecorder.ts';
import { penaltyParam, quantityParam } from './params.ts';
import type { SimulationOutputs, SimulationSettings } from './simulation.ts';

/** The methods of the source documents, which have velocity corrections, are last. */
const METHODS = [
  { value: 'discrete-gradient', title: 'method.discreteGradient' },
  { value: 'implicit-midpoint', title: 'method.midpoint' },
  { value: 'leapfrog', title: 'method.leapfrog' },
  { value: 'yoshida-4', title: 'method.yoshida4' },
  { value: 'yoshida-6', title: 'method.yoshida6' },
  { value: 'yoshida-8', title: 'method.yoshida8' },
  { value: 'semi-implicit-euler', title: 'method.euler' },
  { value: 'linearly-implicit', title: 'method.linear' },
  { value: 'local-global', title: 'method.localGlobal' },
];
const CORRECTED_METHODS = METHODS.slice(6).map(({ value }) => value);
/** Methods that run on the GPU. */
const SPLITTING_METHODS = METHODS.slice(2, 6).map(({ value }) => value);

/** Outside of a worker thread: interval at which it yields and checks for cancellation [ms]. */
const YIELD_INTERVAL = 50;

/** Computes how matter moves, and records its conserved quantities. */
export const simulateNode = defineNode({
  id: 'simulate',
  title: 'node.simulate',
  help: 'node.simulate.help',
  category: 'dynamics',
  heavy: true,
  onGpu: (params) => simulationSettings(params).onGpu,
  params: {
    speedOfLight: {
      kind: 'number',
      title: 'param.speedOfLight',
      help: 'param.simulatedLight.help',
      unit: 'm/s',
      default: 10,
      min: 0.1,
      max: SPEED_OF_LIGHT,
      step: 0.1,
      scale: 'log',
    },
    mechanics: {
      kind: 'choice',
      title: 'param.mechanics',
      help: 'param.mechanics.help',
      default: 'einstein',
      options: [
        { value: 'einstein', title: 'mechanics.einstein' },
        { value: 'newton', title: 'mechanics.newton' },
      ],
    },
    duration: quantityParam({ title: 'param.duration', unit: 's', default: 4, min: 1e-6, max: 1e6 }),
    rate: quantityParam({
      title: 'param.frameRate',
      help: 'param.frameRate.help',
      unit: '1/s',
      default: 24,
      min: 1e-3,
      max: 1e6,
    }),
    method: {
      kind: 'choice',
      title: 'param.method',
      help: 'param.method.help',
      default: 'discrete-gradient',
      options: METHODS,
    },
    correction: {
      kind: 'choice',
      title: 'param.correction',
      help: 'param.correction.help',
      default: '0',
      options: [
        { value: '0', title: 'correction.none' },
        { value: '1', title: 'correction.tangent' },
        { value: '2', title: 'correction.secant' },
        { value: '3', title: 'correction.root' },
      ],
      onlyWhen: { param: 'method', is: CORRECTED_METHODS },
    },
    onGpu: {
      kind: 'boolean',
      title: 'param.onGpu',
      help: 'param.onGpu.help',
      default: false,
      onlyWhen: { param: 'method', is: SPLITTING_METHODS },
    },
    tolerance: quantityParam({
      title: 'param.errorASecond',
      help: 'param.errorASecond.help',
      unit: 'm',
      default: 0,
      max: 1e6,
      step: 1e-6,
    }),
    step: quantityParam({ title: 'param.step', help: 'param.step.help', unit: 's', default: 0, max: 1e6, step: 1e-6 }),
    reach: quantityParam({ title: 'param.touchReach', help: 'param.touchReach.help', unit: 'm', default: 0 }),
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
    for await (const _ of simulation.run(services.openGpu)) {
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
  const { method, correction, mechanics, onGpu, reach, stiffness, ...rest } = params as unknown as SimulateParams;
  return {
    ...rest,
    method: CORRECTED_METHODS.includes(method) ? `${method}-${correction}` : method,
    newtonian: mechanics === 'newton',
    onGpu: onGpu && SPLITTING_METHODS.includes(method),
    touch: { reach, stiffness },
  };
}

interface SimulateParams
  extends Pick<SimulationSettings, 'speedOfLight' | 'duration' | 'rate' | 'step' | 'tolerance' | 'method' | 'onGpu'> {
  readonly correction: string;
  readonly mechanics: string;
  readonly reach: number;
  readonly stiffness: number;
}
