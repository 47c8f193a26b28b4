import { GROUP_OUTPUT } from '../../graph/structure.ts';
import { defineNode } from '../define.ts';
import { isNeverEvaluated } from './structure.ts';

/** Inside a group: what it gives. Its inputs are the group’s outputs. */
export const groupOutputNode = defineNode({
  id: GROUP_OUTPUT,
  title: 'node.groupOutput',
  help: 'node.groupOutput.help',
  category: 'utility',
  params: {},
  inputs: {},
  outputs: {},
  evaluate: isNeverEvaluated,
});
