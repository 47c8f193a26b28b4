import { defineNode } from '../define.ts';

/** What the screen shows and what is saved. */
export const output = defineNode({
  id: 'output',
  title: 'node.output',
  help: 'node.output.help',
  category: 'render',
  params: {},
  inputs: { image: { type: 'image' } },
  outputs: { image: { type: 'image' } },
  evaluate: ({ image }) => ({ image }),
});
