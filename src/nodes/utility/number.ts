import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { numberParam } from './anyNumber.ts';

/** A number for several inputs. */
export const numberNode = defineNode({
  id: 'number',
  title: msg`Number`,
  help: msg`A number for several inputs.`,
  category: 'utility',
  params: { number: numberParam(msg`Value`) },
  inputs: {},
  outputs: { number: { type: 'number' } },
  evaluate: (_inputs, { number }) => ({ number }),
});
