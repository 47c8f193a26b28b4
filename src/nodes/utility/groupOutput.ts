import { GROUP_OUTPUT } from '../../graph/document/structuralTypes.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** Inside a group: the group’s outputs, as inputs. */
export const groupOutputNode = defineNode({
  id: GROUP_OUTPUT,
  title: 'node.groupOutput',
  help: 'node.groupOutput.help',
  category: 'utility',
  params: {},
  inputs: {},
  outputs: {},
  evaluate: neverEvaluated,
});
