import { settingParams } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** What an ordinary renderer draws of the same scene: light takes no time, and motion changes neither places nor colours. */
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
