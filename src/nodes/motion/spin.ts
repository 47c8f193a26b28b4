import { normalize } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { timeParam, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { assertTimeSpan, assertTurns } from './checkSpan.ts';

/** Rotation in place. */
export const spinNode = defineNode({
  id: 'motion-spin',
  title: msg`Spin`,
  help: msg`Rotates around an axis.`,
  category: 'geometry',
  params: {
    center: vectorParam(msg`Centre`, [0, 0, 0], 'm'),
    axis: vectorParam(msg`Axis`, [0, 1, 0]),
    rate: {
      kind: 'number',
      title: msg`Rate`,
      unit: 'rad/s',
      default: 1,
      min: -1e9,
      max: 1e9,
      step: 0.01,
      slider: false,
    },
    from: timeParam(msg`From`, 0),
    to: timeParam(msg`To`, 60),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { axis, ...spin }, { node }) {
    assertTimeSpan(spin, node);
    assertTurns(spin.rate, spin, node);
    return { motion: { kind: 'spin', ...spin, axis: normalize(axis, [0, 1, 0]) } };
  },
});
