import { defineNode } from '../defineNode.ts';
import { buildPictureAt } from './pictureFor.ts';

/** The image that is displayed and saved. */
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
