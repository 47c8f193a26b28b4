import { GROUP_INPUT } from '../../graph/document/structuralTypes.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** Inside a group: what comes into it. Its outputs are the group’s inputs. */
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
