import { settingParams } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** What a non-relativistic renderer draws of the same scene: light delay, aberration and Doppler shift are off. */
export const rasterizeNode = defineNode({
  id: 'rasterize',
  title: 'node.rasterizeOrdinary',
  help: 'node.rasterizeOrdinary.help',
  category: 'render',
  params: settingParams('rasterize'),
  inputs: { view: { type: 'view' } },
  outputs: { gbuffer: { type: 'gbuffer' } },
  evaluate: ({ view }, params) => ({
    gbuffer: { ...view, view: 'galilean', colors: 'spectral', dopplerMix: 0, beaming: 0, ...params },
  }),
});
