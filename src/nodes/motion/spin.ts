import { normalize } from '../../math/vec3.ts';
import { defineNode } from '../define.ts';
import { seconds, vector } from '../geometry/shared.ts';
import { checkSpan, checkTurns } from './span.ts';

/** Turning in its place. */
export const spinNode = defineNode({
  id: 'motion-spin',
  title: 'node.spin',
  help: 'node.spin.help',
  category: 'geometry',
  params: {
    center: vector('param.center', [0, 0, 0], 'm'),
    axis: vector('param.axisVector', [0, 1, 0]),
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
    from: seconds('param.from', 0),
    to: seconds('param.to', 60),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { axis, ...spin }, { node }) {
    checkSpan(spin, node);
    checkTurns(spin.rate, spin, node);
    return { motion: { kind: 'spin', ...spin, axis: normalize(axis, [0, 1, 0]) } };
  },
});
