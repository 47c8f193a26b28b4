import { msg } from '../../messages/message.ts';
import { settingParams } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** What a non-relativistic renderer draws of the same scene: light delay, aberration and Doppler shift are off. */
export const rasterizeNode = defineNode({
  id: 'rasterize',
  title: msg`Rasterize`,
  help: msg`Rasterizes like a non-relativistic renderer: as if light were infinitely fast, without Doppler shift and beaming.`,
  category: 'render',
  params: settingParams('rasterize'),
  inputs: { view: { type: 'view' } },
  outputs: { gbuffer: { type: 'gbuffer' } },
  evaluate: ({ view }, params) => ({
    gbuffer: { ...view, view: 'galilean', colors: 'spectral', dopplerMix: 0, beaming: 0, ...params },
  }),
});
