import { msg } from '../../messages/message.ts';
import { settingParam } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** Maps scene-linear radiance to display values. */
export const toneMapNode = defineNode({
  id: 'tone-map',
  title: msg`Tone map`,
  help: msg`Maps radiance to what a screen can show.`,
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
