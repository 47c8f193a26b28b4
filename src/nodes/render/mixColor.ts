import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { primaryGBuffer } from '../frameGraph/buildFrameGraph.ts';

/** Blends two images. */
export const mixColorNode = defineNode({
  id: 'mix-color',
  title: msg`Mix colour`,
  help: msg`Blends two images. Split shows them side by side, wipe moves the border between them.`,
  category: 'render',
  params: {
    mode: {
      kind: 'choice',
      title: msg`Mode`,
      help: msg`Blends linear light: values brighter than white are kept.`,
      default: 'normal',
      options: [
        { value: 'normal', title: msg`Normal` },
        { value: 'multiply', title: msg`Multiply` },
        { value: 'add', title: msg`Add` },
        { value: 'screen', title: msg`Screen` },
        { value: 'overlay', title: msg`Overlay` },
        { value: 'difference', title: msg`Difference` },
        { value: 'split', title: msg`Split` },
        { value: 'wipe', title: msg`Wipe` },
      ],
    },
    alpha: {
      kind: 'number',
      title: msg`Alpha`,
      help: msg`Opacity of the upper image; for split and wipe, position of the border.`,
      default: 0.5,
      min: 0,
      max: 1,
      step: 0.01,
    },
  },
  inputs: {
    below: { type: 'image', title: msg`Below` },
    above: { type: 'image', title: msg`Above` },
    mask: { type: 'mask', optional: true },
  },
  outputs: { image: { type: 'image' } },
  evaluate: ({ below, above, mask }, { mode, alpha }) => ({
    image: {
      step: { kind: 'mix', mode, alpha, below, above, ...(mask && { mask }) },
      gbuffer: primaryGBuffer(below.gbuffer, above.gbuffer),
    },
  }),
});
