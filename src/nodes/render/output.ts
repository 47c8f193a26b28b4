import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { buildPictureAt } from './pictureFor.ts';

/** The image that is displayed and saved. */
export const outputNode = defineNode({
  id: 'output',
  title: msg`Output`,
  help: msg`The image that is displayed and saved.`,
  category: 'render',
  params: {},
  inputs: { image: { type: 'image' } },
  outputs: { picture: { type: 'picture' } },
  evaluate: ({ image }, _, { node }) => ({ picture: buildPictureAt(image, node) }),
});
