import { REROUTE } from '../../graph/document/structuralTypes.ts';
import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { neverEvaluated } from './neverEvaluated.ts';

/** A bend in an edge. */
export const rerouteNode = defineNode({
  id: REROUTE,
  title: msg`Reroute`,
  help: msg`A bend in an edge, to keep it clear of others.`,
  category: 'utility',
  params: {},
  inputs: { in: { type: 'any', title: msg`In` } },
  outputs: { out: { type: 'any', title: msg`Out` } },
  evaluate: neverEvaluated,
});
