import { GROUP_OUTPUT } from '../../graph/document/structuralTypes.ts';
import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** Inside a group: the group’s outputs, as inputs. */
export const groupOutputNode = defineNode({
  id: GROUP_OUTPUT,
  title: msg`Group output`,
  help: msg`The outputs of the group.`,
  category: 'utility',
  params: {},
  inputs: {},
  outputs: {},
  evaluate: neverEvaluated,
});
