import { GROUP } from '../../graph/structure.ts';
import { defineNode } from '../define.ts';
import { isNeverEvaluated } from './structure.ts';

/** Nodes as one node. Its sockets are those of its definition in the document. */
export const groupNode = defineNode({
  id: GROUP,
  title: 'node.group',
  help: 'node.group.help',
  category: 'utility',
  params: { group: { kind: 'text', title: 'node.group', default: '' } },
  inputs: {},
  outputs: {},
  evaluate: isNeverEvaluated,
});
