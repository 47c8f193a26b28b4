import { normalize } from '../../math/vec3.ts';
import { timeParam, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { assertTimeSpan, assertTurns } from './checkSpan.ts';

/** Rotation in place. */
export const spinNode = defineNode({
  id: 'motion-spin',
  title: 'node.spin',
  help: 'node.spin.help',
  category: 'geometry',
  params: {
    center: vectorParam('param.center', [0, 0, 0], 'm'),
    axis: vectorParam('param.axisVector', [0, 1, 0]),
    rate: {
      kind: 'number',
      title: 'param.rate',
      unit: 'rad/s',
      default: 1,
      min: -1e9,
      max: 1e9,
      step: 0.01,
      slider: false,
    },
    from: timeParam('param.from', 0),
    to: timeParam('param.to', 60),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { axis, ...spin }, { node }) {
    assertTimeSpan(spin, node);
    assertTurns(spin.rate, spin, node);
    return { motion: { kind: 'spin', ...spin, axis: normalize(axis, [0, 1, 0]) } };
  },
});
