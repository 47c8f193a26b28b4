import { GROUP } from '../../graph/document/structuralTypes.ts';
import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** A group as one node. Its sockets are those of its definition in the document. */
export const groupNode = defineNode({
  id: GROUP,
  title: msg`Group`,
  help: msg`Several nodes as one, which can be used any number of times.`,
  category: 'utility',
  params: { group: { kind: 'text', title: msg`Group`, default: '' } },
  inputs: {},
  outputs: {},
  evaluate: neverEvaluated,
});
