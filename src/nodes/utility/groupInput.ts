import { GROUP_INPUT } from '../../graph/document/structuralTypes.ts';
import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** Inside a group: the group’s inputs, as outputs. */
export const groupInputNode = defineNode({
  id: GROUP_INPUT,
  title: msg`Group input`,
  help: msg`The inputs of the group.`,
  category: 'utility',
  params: {},
  inputs: {},
  outputs: {},
  evaluate: neverEvaluated,
});
