import { defineNode } from '../defineNode.ts';

/** One of two inputs, of any type; the other is not evaluated. */
export const switchNode = defineNode({
  id: 'switch',
  title: 'node.switch',
  help: 'node.switch.help',
  category: 'utility',
  params: { second: { kind: 'boolean', title: 'param.second', help: 'param.second.help', default: false } },
  inputs: { a: { type: 'any', title: 'A' }, b: { type: 'any', title: 'B' } },
  outputs: { out: { type: 'any', title: 'socket.out' } },
  needs: ({ second }) => [second ? 'b' : 'a'],
  evaluate: ({ a, b }, { second }) => ({ out: second ? b : a }),
});
