import { settingParams } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** Rasterizes what the observer sees into a G-buffer. */
export const relativityRasterizeNode = defineNode({
  id: 'relativity-rasterize',
  title: 'node.rasterize',
  help: 'node.rasterize.help',
  category: 'render',
  params: settingParams('relativity-rasterize'),
  inputs: { view: { type: 'view' } },
  outputs: { gbuffer: { type: 'gbuffer' } },
  evaluate: ({ view }, params) => ({ gbuffer: { ...view, ...params } }),
});
