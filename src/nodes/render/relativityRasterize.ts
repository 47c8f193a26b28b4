import { msg } from '../../messages/message.ts';
import { settingParams } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';

/** Rasterizes what the observer sees into a G-buffer. */
export const relativityRasterizeNode = defineNode({
  id: 'relativity-rasterize',
  title: msg`Relativity rasterize`,
  help: msg`Rasterizes what the observer sees into a G-buffer: per pixel the surface, its emission event, its velocity and its Doppler factor.`,
  category: 'render',
  params: settingParams('relativity-rasterize'),
  inputs: { view: { type: 'view' } },
  outputs: { gbuffer: { type: 'gbuffer' } },
  evaluate: ({ view }, params) => ({ gbuffer: { ...view, ...params } }),
});
