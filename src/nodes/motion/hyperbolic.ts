import { ORIGIN } from '../../scene/defaults.ts';
import { defineNode } from '../define.ts';
import { seconds, vector } from '../geometry/shared.ts';

/** With a constant proper acceleration, at rest for a moment. */
export const hyperbolicNode = defineNode({
  id: 'motion-hyperbolic',
  title: 'node.hyperbolic',
  help: 'node.hyperbolic.help',
  category: 'geometry',
  params: {
    acceleration: vector('param.properAcceleration', [1, 0, 0], 'm/s²'),
    restAt: seconds('param.restAt', 0),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate: (_inputs, { acceleration, restAt }) => ({
    motion: {
      kind: 'frame',
      motion: { kind: 'hyperbolic', pose: ORIGIN, properAcceleration: acceleration, t0: restAt },
    },
  }),
});
