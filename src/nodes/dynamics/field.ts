import { vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { quantityParam } from './params.ts';

/** A field that acts on everything simulated; several add up. */
export const fieldNode = defineNode({
  id: 'field',
  title: 'node.field',
  help: 'node.field.help',
  category: 'dynamics',
  params: {
    gravity: { ...vectorParam('param.gravity', [0, -9.8, 0], 'm/s²'), help: 'param.gravity.help' },
    drag: quantityParam({ title: 'param.drag', help: 'param.drag.help', unit: '1/s', default: 0, max: 1e6 }),
    electric: vectorParam('param.electric', [0, 0, 0], 'V/m'),
    magnetic: vectorParam('param.magnetic', [0, 0, 0], 'T'),
    coulomb: { kind: 'boolean', title: 'param.coulomb', help: 'param.coulomb.help', default: false },
  },
  inputs: {},
  outputs: { matter: { type: 'matter' } },
  evaluate: (_inputs, field, { node }) => ({ matter: { kind: 'field', node, ...field } }),
});
