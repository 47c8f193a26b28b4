import { defineNode } from '../define.ts';
import { anyNumber } from './anyNumber.ts';

/** A number that several inputs share. */
export const numberNode = defineNode({
  id: 'number',
  title: 'node.number',
  help: 'node.number.help',
  category: 'utility',
  params: { number: anyNumber('socket.number') },
  inputs: {},
  outputs: { number: { type: 'number' } },
  evaluate: (_inputs, { number }) => ({ number }),
});
