import { NodeRefusal } from '../../graph/nodeType.ts';
import { defineNode } from '../define.ts';
import { PlanError, planned } from '../plan.ts';

/** What the screen shows and what is saved. */
export const output = defineNode({
  id: 'output',
  title: 'node.output',
  help: 'node.output.help',
  category: 'render',
  params: {},
  inputs: { image: { type: 'image' } },
  outputs: { picture: { type: 'picture' } },
  evaluate({ image }, _, { node }) {
    try {
      return { picture: planned(image) };
    } catch (error) {
      if (!(error instanceof PlanError)) throw error;
      throw new NodeRefusal({ severity: 'error', code: 'picture.large', place: node, message: error.message });
    }
  },
});
