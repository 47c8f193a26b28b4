import { msg } from '../../messages/message.ts';
import { settingParams } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** Shades a G-buffer, each surface in its rest frame: the radiance that the observer receives. */
export const deferredLightingNode = defineNode({
  id: 'deferred-lighting',
  title: msg`Deferred lighting`,
  help: msg`Shades a G-buffer, each surface in its own rest frame: the radiance that the observer receives.`,
  category: 'render',
  params: {
    ...settingParams('deferred-lighting'),
    occlusion: {
      kind: 'boolean',
      title: msg`Ambient occlusion`,
      help: msg`Dims the light of the sky where it is occluded, in corners and under objects.`,
      default: true,
    },
  },
  inputs: { gbuffer: { type: 'gbuffer' } },
  outputs: { image: { type: 'image' } },
  evaluate: ({ gbuffer }, { shadows, occlusion }) => ({
    image: { step: { kind: 'light', buffer: gbuffer, shadows, occlusion }, gbuffer },
  }),
});
