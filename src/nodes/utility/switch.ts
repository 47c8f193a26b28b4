import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';

/** One of two inputs, of any type; the other is not evaluated. */
export const switchNode = defineNode({
  id: 'switch',
  title: msg`Switch`,
  help: msg`One of two inputs, of any type. The other is not evaluated.`,
  category: 'utility',
  params: { second: { kind: 'boolean', title: msg`Second`, help: msg`Off: passes A. On: passes B.`, default: false } },
  inputs: { a: { type: 'any', title: 'A' }, b: { type: 'any', title: 'B' } },
  outputs: { out: { type: 'any', title: msg`Out` } },
  needs: ({ second }) => [second ? 'b' : 'a'],
  evaluate: ({ a, b }, { second }) => ({ out: second ? b : a }),
});
