import { IDENTITY } from '../../math/quat.ts';
import { scale, type Vec3 } from '../../math/vec3.ts';
import { defineNode } from '../define.ts';
import { seconds, vector } from '../geometry/shared.ts';

/** At one velocity, along a straight line, for ever. */
export const uniformNode = defineNode({
  id: 'motion-uniform',
  title: 'node.uniform',
  help: 'node.uniform.help',
  category: 'geometry',
  params: { velocity: vector('param.velocity', [1, 0, 0], 'm/s'), at: seconds('param.passes', 0) },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { velocity, at }) {
    const pose = { position: scale(velocity, -at) as Vec3, orientation: IDENTITY };
    return { motion: { kind: 'frame', motion: { kind: 'uniform', pose, velocity } } };
  },
});
