import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';

/** A colour for several inputs, linear sRGB. */
export const colorNode = defineNode({
  id: 'color',
  title: msg`Colour`,
  help: msg`A colour for several inputs.`,
  category: 'utility',
  params: { color: { kind: 'color', title: msg`Colour`, default: [0.5, 0.5, 0.5] } },
  inputs: {},
  outputs: { color: { type: 'color' } },
  evaluate: (_inputs, { color }) => ({ color }),
});
