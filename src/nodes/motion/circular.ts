import { normalize } from '../../math/vec3.ts';
import { timeParam, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { lengthParam } from '../geometry/primitives/definePrimitive.ts';
import { assertTimeSpan, assertTurns } from './checkSpan.ts';

/** Around a circle at constant speed. */
export const circularNode = defineNode({
  id: 'motion-circular',
  title: 'node.circular',
  help: 'node.circular.help',
  category: 'geometry',
  params: {
    center: vectorParam('param.center', [0, 0, 0], 'm'),
    axis: vectorParam('param.axisVector', [0, 1, 0]),
    radius: lengthParam('param.radius', 4),
    speed: {
      kind: 'number',
      title: 'param.speed',
      help: 'param.speedRound.help',
      unit: 'm/s',
      default: 1,
      min: -1e9,
      max: 1e9,
      step: 0.01,
      slider: false,
    },
    facing: { kind: 'boolean', title: 'param.facing', help: 'param.facing.help', default: true },
    from: timeParam('param.from', 0),
    to: timeParam('param.to', 60),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { speed, axis, ...circle }, { node }) {
    const rate = speed / circle.radius;
    assertTimeSpan(circle, node);
    assertTurns(rate, circle, node);
    return { motion: { kind: 'circle', ...circle, axis: normalize(axis, [0, 1, 0]), rate } };
  },
});
