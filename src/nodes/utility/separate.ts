import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';

/** Components of a vector or a colour. */
export const separateNode = defineNode({
  id: 'separate',
  title: msg`Separate`,
  help: msg`The components of a vector or a colour.`,
  category: 'utility',
  params: {},
  inputs: { vector: { type: 'vector', title: msg`Vector` } },
  outputs: { x: { type: 'number', title: 'X' }, y: { type: 'number', title: 'Y' }, z: { type: 'number', title: 'Z' } },
  evaluate: ({ vector: [x, y, z] }) => ({ x, y, z }),
});
