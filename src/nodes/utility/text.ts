import { defineNode } from '../defineNode.ts';

/** A text for several inputs. */
export const textNode = defineNode({
  id: 'text',
  title: 'node.text',
  help: 'node.text.help',
  category: 'utility',
  params: { text: { kind: 'text', title: 'node.text', default: '' } },
  inputs: {},
  outputs: { text: { type: 'text' } },
  evaluate: (_inputs, { text }) => ({ text }),
});
