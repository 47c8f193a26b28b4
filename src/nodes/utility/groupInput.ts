import { GROUP_INPUT } from '../../graph/document/structuralTypes.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** Inside a group: the group’s inputs, as outputs. */
export const groupInputNode = defineNode({
  id: GROUP_INPUT,
  title: 'node.groupInput',
  help: 'node.groupInput.help',
  category: 'utility',
  params: {},
  inputs: {},
  outputs: {},
  evaluate: neverEvaluated,
});
