import { defineNode } from '../define.ts';
import { anyNumber } from './anyNumber.ts';

/** Three numbers as one vector. */
export const vectorNode = defineNode({
  id: 'vector',
  title: 'node.vector',
  help: 'node.vector.help',
  category: 'utility',
  params: { x: anyNumber('X'), y: anyNumber('Y'), z: anyNumber('Z') },
  inputs: {},
  outputs: { vector: { type: 'vector' } },
  evaluate: (_inputs, { x, y, z }) => ({ vector: [x, y, z] }),
});
