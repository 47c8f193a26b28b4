import { normalize } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { facingParam, timeParam, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { lengthParam } from '../geometry/primitives/definePrimitive.ts';
import { assertTimeSpan, assertTurns } from './checkSpan.ts';

/** Around a circle at constant speed. */
export const circularNode = defineNode({
  id: 'motion-circular',
  title: msg`Circular motion`,
  help: msg`Around a circle at constant speed.`,
  category: 'geometry',
  params: {
    center: vectorParam(msg`Centre`, [0, 0, 0], 'm'),
    axis: vectorParam(msg`Axis`, [0, 1, 0]),
    radius: lengthParam(msg`Radius`, 4),
    speed: {
      kind: 'number',
      title: msg`Speed`,
      help: msg`Along the circle; negative values reverse the direction.`,
      unit: 'm/s',
      default: 1,
      min: -1e9,
      max: 1e9,
      step: 0.01,
      slider: false,
    },
    facing: facingParam,
    from: timeParam(msg`From`, 0),
    to: timeParam(msg`To`, 60),
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
