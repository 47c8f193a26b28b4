import { defineNode } from '../defineNode.ts';
import { buildPictureAt } from './pictureFor.ts';

/** What the screen shows and what is saved. */
export const outputNode = defineNode({
  id: 'output',
  title: 'node.output',
  help: 'node.output.help',
  category: 'render',
  params: {},
  inputs: { image: { type: 'image' } },
  outputs: { picture: { type: 'picture' } },
  evaluate: ({ image }, _, { node }) => ({ picture: buildPictureAt(image, node) }),
});
