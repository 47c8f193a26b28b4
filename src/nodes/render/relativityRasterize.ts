import { defineNode } from '../defineNode.ts';
import { rasterizeParams } from './rasterizeParams.ts';

/** Rasterizes what the observer sees into a G-buffer. */
export const relativityRasterizeNode = defineNode({
  id: 'relativity-rasterize',
  title: 'node.rasterize',
  help: 'node.rasterize.help',
  category: 'render',
  params: {
    colors: {
      kind: 'choice',
      title: 'param.colors',
      help: 'param.colors.help',
      default: 'spectral',
      options: [
        { value: 'spectral', title: 'colors.spectral' },
        { value: 'approximate', title: 'colors.approximate' },
      ],
    },
    dopplerMix: {
      kind: 'number',
      title: 'param.dopplerMix',
      help: 'param.dopplerMix.help',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
      physical: 1,
    },
    beaming: {
      kind: 'number',
      title: 'param.beaming',
      help: 'param.beaming.help',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
      physical: 1,
    },
    ...rasterizeParams,
  },
  inputs: { view: { type: 'view' } },
  outputs: { gbuffer: { type: 'gbuffer' } },
  evaluate: ({ view }, params) => ({ gbuffer: { ...view, ...params } }),
});
