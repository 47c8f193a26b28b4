import { defineNode } from '../defineNode.ts';

/** Ambient occlusion as a mask. */
export const ambientOcclusionNode = defineNode({
  id: 'ambient-occlusion',
  title: 'node.occlusion',
  help: 'node.occlusion.help',
  category: 'render',
  params: {
    radius: {
      kind: 'number',
      title: 'param.occlusionRadius',
      help: 'param.occlusionRadius.help',
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
