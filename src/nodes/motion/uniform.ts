import { IDENTITY } from '../../math/quat.ts';
import { scale, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { timeParam, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Constant velocity along a straight line, for all time. */
export const uniformNode = defineNode({
  id: 'motion-uniform',
  title: msg`Uniform motion`,
  help: msg`Constant velocity along a straight line, for all time.`,
  category: 'geometry',
  params: { velocity: vectorParam(msg`Velocity`, [1, 0, 0], 'm/s'), at: timeParam(msg`Passes its position at`, 0) },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { velocity, at }) {
    const pose = { position: scale(velocity, -at) as Vec3, orientation: IDENTITY };
    return { motion: { kind: 'frame', motion: { kind: 'uniform', pose, velocity } } };
  },
});
