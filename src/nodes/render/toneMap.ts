import { settingParam } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** Maps scene-linear radiance to display values. */
export const toneMapNode = defineNode({
  id: 'tone-map',
  title: 'node.toneMap',
  help: 'node.toneMap.help',
  category: 'render',
  params: {
    tone: settingParam('tone'),
    metering: settingParam('metering'),
    exposure: settingParam('exposure'),
  },
  inputs: { image: { type: 'image' } },
  outputs: { image: { type: 'image' } },
  evaluate: ({ image }, { tone, metering, exposure }) => ({
    image: { step: { kind: 'tone', tone, metering, exposure, image }, gbuffer: image.gbuffer },
  }),
});
