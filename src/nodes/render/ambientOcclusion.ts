import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';

/** Ambient occlusion as a mask. */
export const ambientOcclusionNode = defineNode({
  id: 'ambient-occlusion',
  title: msg`Ambient occlusion`,
  help: msg`The visible fraction of the sky at each point as a mask, which can be smoothed, viewed, or multiplied with an image.`,
  category: 'render',
  params: {
    radius: {
      kind: 'number',
      title: msg`Radius (0: automatic)`,
      help: msg`Objects farther away than this do not occlude.`,
      unit: 'm',
      default: 0,
      min: 0,
      max: 1e9,
      step: 0.1,
      scale: 'log',
    },
  },
  inputs: { gbuffer: { type: 'gbuffer' } },
  outputs: { mask: { type: 'mask' } },
  evaluate: ({ gbuffer }, { radius }) => ({
    mask: { step: { kind: 'occlusion', buffer: gbuffer, radius }, gbuffer },
  }),
});
