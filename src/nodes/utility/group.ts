import { GROUP } from '../../graph/document/structuralTypes.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** A group as one node. Its sockets are those of its definition in the document. */
export const groupNode = defineNode({
  id: GROUP,
  title: 'node.group',
  help: 'node.group.help',
  category: 'utility',
  params: { group: { kind: 'text', title: 'node.group', default: '' } },
  inputs: {},
  outputs: {},
  evaluate: neverEvaluated,
});
