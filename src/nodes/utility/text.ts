import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';

/** A text for several inputs. */
export const textNode = defineNode({
  id: 'text',
  title: msg`Text`,
  help: msg`A text for several inputs.`,
  category: 'utility',
  params: { text: { kind: 'text', title: msg`Text`, default: '' } },
  inputs: {},
  outputs: { text: { type: 'text' } },
  evaluate: (_inputs, { text }) => ({ text }),
});
