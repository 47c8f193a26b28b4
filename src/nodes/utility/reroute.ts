import { REROUTE } from '../../graph/document/structuralTypes.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** A bend in an edge. */
export const rerouteNode = defineNode({
  id: REROUTE,
  title: 'node.reroute',
  help: 'node.reroute.help',
  category: 'utility',
  params: {},
  inputs: { in: { type: 'any', title: 'socket.in' } },
  outputs: { out: { type: 'any', title: 'socket.out' } },
  evaluate: neverEvaluated,
});
