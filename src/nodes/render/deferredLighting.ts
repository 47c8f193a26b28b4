import { settingParams } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** Shades a G-buffer, each surface in its rest frame: the radiance that the observer receives. */
export const deferredLightingNode = defineNode({
  id: 'deferred-lighting',
  title: 'node.lighting',
  help: 'node.lighting.help',
  category: 'render',
  params: {
    ...settingParams('deferred-lighting'),
    occlusion: { kind: 'boolean', title: 'param.occlusion', help: 'param.occlusion.help', default: true },
  },
  inputs: { gbuffer: { type: 'gbuffer' } },
  outputs: { image: { type: 'image' } },
  evaluate: ({ gbuffer }, { shadows, occlusion }) => ({
    image: { step: { kind: 'light', buffer: gbuffer, shadows, occlusion }, gbuffer },
  }),
});
