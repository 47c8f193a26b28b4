import { defineNode } from '../defineNode.ts';

/** A colour for several inputs, linear sRGB. */
export const colorNode = defineNode({
  id: 'color',
  title: 'node.color',
  help: 'node.color.help',
  category: 'utility',
  params: { color: { kind: 'color', title: 'node.color', default: [0.5, 0.5, 0.5] } },
  inputs: {},
  outputs: { color: { type: 'color' } },
  evaluate: (_inputs, { color }) => ({ color }),
});
