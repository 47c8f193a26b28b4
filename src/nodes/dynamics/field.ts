import { defineNode } from '../define.ts';
import { vector } from '../geometry/shared.ts';
import { amount } from './shared.ts';

/** What acts on all that is simulated; several add up. */
export const fieldNode = defineNode({
  id: 'field',
  title: 'node.field',
  help: 'node.field.help',
  category: 'dynamics',
  params: {
    gravity: { ...vector('param.gravity', [0, -9.8, 0], 'm/s²'), help: 'param.gravity.help' },
    drag: amount({ title: 'param.drag', help: 'param.drag.help', unit: '1/s', default: 0, max: 1e6 }),
    electric: vector('param.electric', [0, 0, 0], 'V/m'),
    magnetic: vector('param.magnetic', [0, 0, 0], 'T'),
    coulomb: { kind: 'boolean', title: 'param.coulomb', help: 'param.coulomb.help', default: false },
  },
  inputs: {},
  outputs: { matter: { type: 'matter' } },
  evaluate: (_inputs, field, { node }) => ({ matter: { kind: 'field', node, ...field } }),
});
