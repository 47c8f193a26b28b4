import { defineNode } from '../defineNode.ts';

/** Components of a vector or a colour. */
export const separateNode = defineNode({
  id: 'separate',
  title: 'node.separate',
  help: 'node.separate.help',
  category: 'utility',
  params: {},
  inputs: { vector: { type: 'vector', title: 'node.vector' } },
  outputs: { x: { type: 'number', title: 'X' }, y: { type: 'number', title: 'Y' }, z: { type: 'number', title: 'Z' } },
  evaluate: ({ vector: [x, y, z] }) => ({ x, y, z }),
});
