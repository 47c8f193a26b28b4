import { defineNode } from '../defineNode.ts';
import { numberParam } from './anyNumber.ts';

/** A number for several inputs. */
export const numberNode = defineNode({
  id: 'number',
  title: 'node.number',
  help: 'node.number.help',
  category: 'utility',
  params: { number: numberParam('socket.number') },
  inputs: {},
  outputs: { number: { type: 'number' } },
  evaluate: (_inputs, { number }) => ({ number }),
});
