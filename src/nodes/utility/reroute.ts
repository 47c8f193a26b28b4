import { REROUTE } from '../../graph/structure.ts';
import { defineNode } from '../define.ts';
import { isNeverEvaluated } from './structure.ts';

/** A bend in an edge, to keep it clear of others. */
export const rerouteNode = defineNode({
  id: REROUTE,
  title: 'node.reroute',
  help: 'node.reroute.help',
  category: 'utility',
  params: {},
  inputs: { in: { type: 'any', title: 'socket.in' } },
  outputs: { out: { type: 'any', title: 'socket.out' } },
  evaluate: isNeverEvaluated,
});
