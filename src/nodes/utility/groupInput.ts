import { GROUP_INPUT } from '../../graph/structure.ts';
import { defineNode } from '../define.ts';
import { isNeverEvaluated } from './structure.ts';

/** Inside a group: what comes into it. Its outputs are the group’s inputs. */
export const groupInputNode = defineNode({
  id: GROUP_INPUT,
  title: 'node.groupInput',
  help: 'node.groupInput.help',
  category: 'utility',
  params: {},
  inputs: {},
  outputs: {},
  evaluate: isNeverEvaluated,
});
