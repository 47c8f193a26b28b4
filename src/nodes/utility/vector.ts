import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { numberParam } from './anyNumber.ts';

/** Three numbers as a vector. */
export const vectorNode = defineNode({
  id: 'vector',
  title: msg`Vector`,
  help: msg`A vector of three numbers.`,
  category: 'utility',
  params: { x: numberParam('X'), y: numberParam('Y'), z: numberParam('Z') },
  inputs: {},
  outputs: { vector: { type: 'vector' } },
  evaluate: (_inputs, { x, y, z }) => ({ vector: [x, y, z] }),
});
