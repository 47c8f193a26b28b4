import { msg } from '../../messages/message.ts';
import { IDENTITY_POSE } from '../../scene/defaults.ts';
import { timeParam, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Constant proper acceleration, momentarily at rest once. */
export const hyperbolicNode = defineNode({
  id: 'motion-hyperbolic',
  title: msg`Hyperbolic motion`,
  help: msg`Constant proper acceleration: approaches c but never reaches it.`,
  category: 'geometry',
  params: {
    acceleration: vectorParam(msg`Proper acceleration`, [1, 0, 0], 'm/s²'),
    restAt: timeParam(msg`At rest at`, 0),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate: (_inputs, { acceleration, restAt }) => ({
    motion: {
      kind: 'frame',
      motion: { kind: 'hyperbolic', pose: IDENTITY_POSE, properAcceleration: acceleration, t0: restAt },
    },
  }),
});
