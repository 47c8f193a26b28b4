import { defineNode } from '../defineNode.ts';
import { primaryGBuffer } from '../frameGraph/buildFrameGraph.ts';

/** Blends two images. */
export const mixColorNode = defineNode({
  id: 'mix-color',
  title: 'node.mixColor',
  help: 'node.mixColor.help',
  category: 'render',
  params: {
    mode: {
      kind: 'choice',
      title: 'param.mixMode',
      help: 'param.mixMode.help',
      default: 'normal',
      options: [
        { value: 'normal', title: 'mix.normal' },
        { value: 'multiply', title: 'mix.multiply' },
        { value: 'add', title: 'mix.add' },
        { value: 'screen', title: 'mix.screen' },
        { value: 'overlay', title: 'mix.overlay' },
        { value: 'difference', title: 'mix.difference' },
        { value: 'split', title: 'mix.split' },
        { value: 'wipe', title: 'mix.wipe' },
      ],
    },
    alpha: {
      kind: 'number',
      title: 'param.alpha',
      help: 'param.alpha.help',
      default: 0.5,
      min: 0,
      max: 1,
      step: 0.01,
    },
  },
  inputs: {
    below: { type: 'image', title: 'socket.below' },
    above: { type: 'image', title: 'socket.above' },
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
